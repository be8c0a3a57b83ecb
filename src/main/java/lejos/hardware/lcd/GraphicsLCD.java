package lejos.hardware.lcd;

/**
 * A display to draw on, pixel by pixel. Everything except {@code clear}, {@code setPixel}, {@code getPixel} and {@code
 * bitBlt} is translated.
 */
public interface GraphicsLCD extends CommonLCD {
    /** Transform: left and right exchanged. */
    int TRANS_MIRROR = 2;
    /** Transform: top and bottom exchanged. */
    int TRANS_MIRROR_ROT180 = 1;
    /** Transform: mirrored, then turned 270° clockwise. */
    int TRANS_MIRROR_ROT270 = 4;
    /** Transform: mirrored, then turned 90° clockwise. */
    int TRANS_MIRROR_ROT90 = 7;
    /** Transform: none. */
    int TRANS_NONE = 0;
    /** Transform: turned 180°. */
    int TRANS_ROT180 = 3;
    /** Transform: turned 270° clockwise. */
    int TRANS_ROT270 = 6;
    /** Transform: turned 90° clockwise. */
    int TRANS_ROT90 = 5;
    /** Anchor: the point is the horizontal middle. */
    int HCENTER = 1;
    /** Anchor: the point is the vertical middle (images only; text takes it as {@link #TOP}). */
    int VCENTER = 2;
    /** Anchor: the point is at the left edge. */
    int LEFT = 4;
    /** Anchor: the point is at the right edge. */
    int RIGHT = 8;
    /** Anchor: the point is at the upper edge. */
    int TOP = 16;
    /** Anchor: the point is at the lower edge. */
    int BOTTOM = 32;
    /** Anchor: the point is at the baseline of the text. */
    int BASELINE = 64;
    /** Stroke style: every pixel. */
    int SOLID = 0;
    /** Stroke style: every second pixel. */
    int DOTTED = 1;
    /** Colour black. */
    int BLACK = 0;
    /** Colour white. */
    int WHITE = 0xffffff;

    /**
     * Sets one pixel, untranslated; off-screen pixels are ignored.
     *
     * @param color 1 = black, anything else white; in particular {@link #BLACK}, which is 0, gives white
     */
    void setPixel(int x, int y, int color);

    /** One pixel, untranslated: 1 = black, 0 = white or off-screen. */
    int getPixel(int x, int y);

    /**
     * Draws text on a filled background.
     *
     * @param anchor where (x, y) is within the text, 0 = {@code TOP | LEFT}
     * @param inverted if true the cells are filled with the colour and the text is drawn in the opposite one
     */
    void drawString(String str, int x, int y, int anchor, boolean inverted);

    /**
     * Draws text without a background; characters outside 32 to 127 are left out.
     *
     * @param anchor where (x, y) is within the text, 0 = {@code TOP | LEFT}
     */
    void drawString(String str, int x, int y, int anchor);

    /**
     * Draws a part of a text.
     *
     * @throws StringIndexOutOfBoundsException if the part is not within the text
     */
    void drawSubstring(String str, int offset, int len, int x, int y, int anchor);

    /** Draws a character. */
    void drawChar(char character, int x, int y, int anchor);

    /**
     * Draws a part of an array of characters.
     *
     * @throws ArrayIndexOutOfBoundsException if the part is not within the array
     */
    void drawChars(char[] data, int offset, int length, int x, int y, int anchor);

    /** {@link #SOLID} or {@link #DOTTED}. */
    int getStrokeStyle();

    /**
     * Sets the style of lines, rectangles and arcs.
     *
     * @throws IllegalArgumentException if it is neither {@link #SOLID} nor {@link #DOTTED}
     */
    void setStrokeStyle(int style);

    /**
     * Combines a part of an image with the display.
     *
     * @param src image, or null for the display itself
     * @param rop one of the {@code ROP_} constants
     */
    void drawRegionRop(Image src, int sx, int sy, int w, int h, int x, int y, int anchor, int rop);

    /**
     * Combines a transformed part of an image with the display.
     *
     * @param src image, or null for the display itself
     * @param transform one of the {@code TRANS_} constants
     * @param rop one of the {@code ROP_} constants
     */
    void drawRegionRop(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor, int rop);

    /**
     * Draws a transformed part of an image over what is there.
     *
     * @param transform one of the {@code TRANS_} constants
     */
    void drawRegion(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor);

    /** Draws an image over what is there. */
    void drawImage(Image src, int x, int y, int anchor);

    /** Draws a line; both ends belong to it. */
    void drawLine(int x0, int y0, int x1, int y1);

    /**
     * Draws a part of the outline of the ellipse in a box of {@code width + 1} by {@code height + 1} pixels.
     *
     * @param startAngle degrees, 0 = 3 o'clock, counter-clockwise
     * @param arcAngle length of the arc in degrees, negative = clockwise
     */
    void drawArc(int x, int y, int width, int height, int startAngle, int arcAngle);

    /** Fills the sector whose outline {@link #drawArc} would draw. */
    void fillArc(int x, int y, int width, int height, int startAngle, int arcAngle);

    /**
     * Draws a rectangle with rounded corners, {@code width + 1} by {@code height + 1} pixels.
     *
     * @param arcWidth width of the ellipse at the corners
     * @param arcHeight height of the ellipse at the corners
     */
    void drawRoundRect(int x, int y, int width, int height, int arcWidth, int arcHeight);

    /**
     * Draws the outline of a rectangle of {@code width + 1} by {@code height + 1} pixels; nothing if either is
     * negative.
     */
    void drawRect(int x, int y, int width, int height);

    /** Fills {@code width} by {@code height} pixels. */
    void fillRect(int x, int y, int width, int height);

    /** Copies a part of the display to another place; the areas may overlap. */
    void copyArea(int sx, int sy, int w, int h, int x, int y, int anchor);

    /** The font of the text. */
    Font getFont();

    /** Sets the font of the text. */
    void setFont(Font f);

    /** Moves the origin of the coordinates by (x, y) pixels. */
    void translate(int x, int y);

    /** Present x of the origin. */
    int getTranslateX();

    /** Present y of the origin. */
    int getTranslateY();

    /** Sets the colour: {@link #BLACK}, or white for every other value. */
    void setColor(int rgb);

    /**
     * Sets the colour: black if all parts are 0, else white.
     *
     * @throws IllegalArgumentException if a part is outside 0 to 255
     */
    void setColor(int red, int green, int blue);
}
