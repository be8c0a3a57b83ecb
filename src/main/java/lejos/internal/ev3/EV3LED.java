package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import lejos.hardware.LED;

/** The LEDs behind the keys, which always show the same. */
public class EV3LED implements LED {
    /** Colour: off. */
    public static int COLOR_NONE = 0;
    /** Colour green. */
    public static int COLOR_GREEN = 1;
    /** Colour red. */
    public static int COLOR_RED = 2;
    /** Colour orange. */
    public static int COLOR_ORANGE = 3;
    /** Pattern: steady. */
    public static int PATTERN_ON = 0;
    /** Pattern: 250 ms on, 250 ms off. */
    public static int PATTERN_BLINK = 1;
    /** Pattern: two short flashes each second. */
    public static int PATTERN_HEARTBEAT = 2;

    private static final int COLOURS = 3;

    /** The LEDs of the local brick. */
    public EV3LED() {}

    @Override
    public void setPattern(int pattern) {
        BrickAccess.brick().leds().setPattern(pattern);
    }

    /** Shows a colour ({@code COLOR_…}) in a pattern ({@code PATTERN_…}); colour 0 switches off. */
    public void setPattern(int color, int pattern) {
        setPattern(color == COLOR_NONE ? 0 : pattern * COLOURS + color);
    }
}
