package lejos.internal.ev3;

import lejos.hardware.lcd.GraphicsLCD;

/** Turns an anchored point into the upper left corner of a box. */
final class Anchor {
    private Anchor() {}

    /** Left edge of a box of that width; without a horizontal bit the point is the left edge. */
    static int left(int x, int width, int anchor) {
        if ((anchor & GraphicsLCD.RIGHT) != 0) {
            return x - width;
        }
        return (anchor & GraphicsLCD.HCENTER) != 0 ? x - width / 2 : x;
    }

    /** Upper edge of an image of that height; without a vertical bit the point is the upper edge. */
    static int topOfImage(int y, int height, int anchor) {
        if ((anchor & GraphicsLCD.BOTTOM) != 0) {
            return y - height;
        }
        return (anchor & GraphicsLCD.VCENTER) != 0 ? y - height / 2 : y;
    }

    /** Upper edge of a line of text; without a vertical bit, and with {@code VCENTER}, the point is the upper edge. */
    static int topOfText(int y, int height, int baseline, int anchor) {
        if ((anchor & GraphicsLCD.BOTTOM) != 0) {
            return y - height;
        }
        return (anchor & GraphicsLCD.BASELINE) != 0 ? y - baseline : y;
    }
}
