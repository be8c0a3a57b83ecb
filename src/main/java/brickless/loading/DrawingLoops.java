package brickless.loading;

import java.util.Set;

/**
 * Classes of ours whose loops are not charged turn by turn, as data: they draw, copy or print a known number of pixels
 * or characters, and the screen socket charges that as a whole. None of their loops is without end.
 */
final class DrawingLoops {
    private static final Set<String> CLASSES = Set.of(
            "lejos/hardware/lcd/LCDOutputStream", "lejos/internal/ev3/ArcSector", "lejos/internal/ev3/EV3GraphicsLCD",
            "lejos/internal/ev3/EV3TextLCD", "lejos/internal/ev3/EllipseOutline", "lejos/internal/ev3/Pen",
                    "lejos/internal/ev3/PixelCopy",
            "lejos/internal/ev3/PrintedBytes", "lejos/internal/ev3/RasterOperation",
                    "brickless/concurrent/io/ProgramPrintStream");

    private DrawingLoops() {}

    /** Whether a class, by its internal name, is one of them. */
    static boolean contain(String internalName) {
        return CLASSES.contains(internalName);
    }
}
