package lejos.hardware.lcd;

import lejos.hardware.BrickFinder;

/** The screen of the default brick: text in the default font by column and row, pixels, and copying of images. */
public class LCD {
    /** Width of the screen in pixels. */
    public static final int SCREEN_WIDTH = 178;
    /** Height of the screen in pixels. */
    public static final int SCREEN_HEIGHT = 128;
    /** Number of characters of the fonts. */
    public static final int NOOF_CHARS = 96;
    /** Width of a character in pixels. */
    public static final int FONT_WIDTH = 10;
    /** Height of a character in pixels. */
    public static final int FONT_HEIGHT = 16;
    /** Width of a character cell in pixels. */
    public static final int CELL_WIDTH = 10;
    /** Height of a character cell in pixels. */
    public static final int CELL_HEIGHT = 16;
    /** Number of columns. */
    public static final int DISPLAY_CHAR_WIDTH = 17;
    /** Number of rows. */
    public static final int DISPLAY_CHAR_DEPTH = 8;
    /** Result bit: 0. */
    public static final int ROP_CLEAR = CommonLCD.ROP_CLEAR;
    /** Result bit: source and destination. */
    public static final int ROP_AND = CommonLCD.ROP_AND;
    /** Result bit: source and not destination. */
    public static final int ROP_ANDREVERSE = CommonLCD.ROP_ANDREVERSE;
    /** Result bit: source. */
    public static final int ROP_COPY = CommonLCD.ROP_COPY;
    /** Result bit: not source and destination. */
    public static final int ROP_ANDINVERTED = CommonLCD.ROP_ANDINVERTED;
    /** Result bit: destination. */
    public static final int ROP_NOOP = CommonLCD.ROP_NOOP;
    /** Result bit: source exclusive-or destination. */
    public static final int ROP_XOR = CommonLCD.ROP_XOR;
    /** Result bit: source or destination. */
    public static final int ROP_OR = CommonLCD.ROP_OR;
    /** Result bit: neither source nor destination. */
    public static final int ROP_NOR = CommonLCD.ROP_NOR;
    /** Result bit: source equals destination. */
    public static final int ROP_EQUIV = CommonLCD.ROP_EQUIV;
    /** Result bit: not destination. */
    public static final int ROP_INVERT = CommonLCD.ROP_INVERT;
    /** Result bit: source or not destination. */
    public static final int ROP_ORREVERSE = CommonLCD.ROP_ORREVERSE;
    /** Result bit: not source. */
    public static final int ROP_COPYINVERTED = CommonLCD.ROP_COPYINVERTED;
    /** Result bit: not source or destination. */
    public static final int ROP_ORINVERTED = CommonLCD.ROP_ORINVERTED;
    /** Result bit: not both. */
    public static final int ROP_NAND = CommonLCD.ROP_NAND;
    /** Result bit: 1. */
    public static final int ROP_SET = CommonLCD.ROP_SET;

    /** The screen as text. */
    protected static TextLCD t = BrickFinder.getDefault().getTextLCD();
    /** The screen for graphics; the same memory. */
    protected static GraphicsLCD g = BrickFinder.getDefault().getGraphicsLCD();

    private LCD() {}

    /**
     * Combines an image with the screen; see {@link CommonLCD#bitBlt(byte[], int, int, int, int, int, int, int, int,
     * int)}.
     */
    public static void bitBlt(byte[] src, int sw, int sh, int sx, int sy, int dx, int dy, int w, int h, int rop) {
        g.bitBlt(src, sw, sh, sx, sy, dx, dy, w, h, rop);
    }

    /** Draws a character over its cell; characters outside 32 to 127 leave the cell unchanged. */
    public static void drawChar(char c, int x, int y) {
        t.drawChar(c, x, y);
    }

    /** Makes the screen white. */
    public static void clearDisplay() {
        t.clear();
    }

    /** Draws text over its cells; see {@link TextLCD#drawString(String, int, int, boolean)}. */
    public static void drawString(String str, int x, int y, boolean inverted) {
        t.drawString(str, x, y, inverted);
    }

    /** Draws text over its cells, clipped at the right edge. */
    public static void drawString(String str, int x, int y) {
        t.drawString(str, x, y);
    }

    /** Draws a decimal number. */
    public static void drawInt(int i, int x, int y) {
        t.drawInt(i, x, y);
    }

    /** Draws a decimal number right-aligned in at least {@code places} columns. */
    public static void drawInt(int i, int places, int x, int y) {
        t.drawInt(i, places, x, y);
    }

    /** Same as {@link #refresh}. */
    public static void asyncRefresh() {
        t.refresh();
    }

    /** The present time in milliseconds: copying to the screen is immediate. */
    public static long getRefreshCompleteTime() {
        return System.currentTimeMillis();
    }

    /** Returns at once: copying to the screen is immediate. */
    public static void asyncRefreshWait() {
        // Nothing to wait for.
    }

    /** Copies what was drawn to the screen now. */
    public static void refresh() {
        t.refresh();
    }

    /** Makes the screen white; text printed with {@code System.out} is on another layer and stays. */
    public static void clear() {
        t.clear();
    }

    /** The live memory that is drawn into. */
    public static byte[] getDisplay() {
        return t.getDisplay();
    }

    /** The strip image of the default font. */
    public static byte[] getSystemFont() {
        return Font.getDefaultFont().glyphs;
    }

    /**
     * Accepted without effect: the period is always 250 ms.
     *
     * @return 0
     */
    public static int setAutoRefreshPeriod(int period) {
        return t.setAutoRefreshPeriod(period);
    }

    /** Whether what was drawn is copied to the screen every 250 ms. */
    public static void setAutoRefresh(boolean on) {
        t.setAutoRefresh(on);
    }

    /** Sets one pixel: 1 = black, anything else white. */
    public static void setPixel(int x, int y, int color) {
        g.setPixel(x, y, color);
    }

    /** One pixel: 1 = black, 0 = white or off-screen. */
    public static int getPixel(int x, int y) {
        return g.getPixel(x, y);
    }

    /** Combines two images; see {@link CommonLCD}. */
    public static void bitBlt(
            byte[] src, int sw, int sh, int sx, int sy, byte[] dst, int dw, int dh, int dx, int dy, int w, int h,
            int rop) {
        g.bitBlt(src, sw, sh, sx, sy, dst, dw, dh, dx, dy, w, h, rop);
    }

    /** Moves everything up by a text row; the last row becomes blank. */
    public static void scroll() {
        t.scroll();
    }

    /**
     * Clears {@code n} cells from column {@code x} of row {@code y}. (In leJOS 0.9.1 this cleared the whole screen.)
     */
    public static void clear(int x, int y, int n) {
        t.clear(x, y, n);
    }

    /** Clears a text row. */
    public static void clear(int y) {
        t.clear(y);
    }

    /** Accepted without effect: the EV3's contrast is fixed. */
    public static void setContrast(int contrast) {
        t.setContrast(contrast);
    }

    /** A copy of what the screen shows. */
    public static byte[] getHWDisplay() {
        return t.getHWDisplay();
    }
}
