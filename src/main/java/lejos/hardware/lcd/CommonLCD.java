package lejos.hardware.lcd;

/**
 * What text and graphics displays have in common. Coordinates are pixels, (0, 0) at the top left, y down; 1 is black.
 */
public interface CommonLCD {
    /** Result bit: 0. */
    int ROP_CLEAR = 0x00000000;
    /** Result bit: source and destination. */
    int ROP_AND = 0xff000000;
    /** Result bit: source and not destination. */
    int ROP_ANDREVERSE = 0xff00ff00;
    /** Result bit: source. */
    int ROP_COPY = 0x0000ff00;
    /** Result bit: not source and destination. */
    int ROP_ANDINVERTED = 0xffff0000;
    /** Result bit: destination. */
    int ROP_NOOP = 0x00ff0000;
    /** Result bit: source exclusive-or destination. */
    int ROP_XOR = 0x00ffff00;
    /** Result bit: source or destination. */
    int ROP_OR = 0xffffff00;
    /** Result bit: neither source nor destination. */
    int ROP_NOR = 0xffffffff;
    /** Result bit: source equals destination. */
    int ROP_EQUIV = 0x00ffffff;
    /** Result bit: not destination. */
    int ROP_INVERT = 0x00ff00ff;
    /** Result bit: source or not destination. */
    int ROP_ORREVERSE = 0xffff00ff;
    /** Result bit: not source. */
    int ROP_COPYINVERTED = 0x0000ffff;
    /** Result bit: not source or destination. */
    int ROP_ORINVERTED = 0xff00ffff;
    /** Result bit: not both. */
    int ROP_NAND = 0xff0000ff;
    /** Result bit: 1. */
    int ROP_SET = 0x000000ff;

    /** Copies what was drawn to the screen now. */
    void refresh();

    /** Makes the whole display white. */
    void clear();

    /** Width in pixels. */
    int getWidth();

    /** Height in pixels. */
    int getHeight();

    /** The live memory that is drawn into: rows of whole bytes, lowest bit leftmost. */
    byte[] getDisplay();

    /** A copy of what the screen shows. */
    byte[] getHWDisplay();

    /** Accepted without effect: the EV3's contrast is fixed. */
    void setContrast(int contrast);

    /**
     * Combines an image with this display, clipped to both.
     *
     * @param src image memory, rows of whole bytes; may be null if {@code rop} does not look at it
     * @param sw width of the image in pixels
     * @param sh height of the image in pixels
     * @param sx left edge of the part to copy; nothing is drawn if it is negative after clipping the destination
     * @param sy upper edge of the part to copy; nothing is drawn if it is negative after clipping the destination
     * @param dx left edge of the result
     * @param dy upper edge of the result
     * @param w width of the part in pixels
     * @param h height of the part in pixels
     * @param rop one of the {@code ROP_} constants
     */
    void bitBlt(byte[] src, int sw, int sh, int sx, int sy, int dx, int dy, int w, int h, int rop);

    /**
     * Combines an image with another one, as {@link #bitBlt(byte[], int, int, int, int, int, int, int, int, int)} does
     * with this display.
     *
     * @param dst memory to draw into
     * @param dw width of that image in pixels
     * @param dh height of that image in pixels
     */
    void bitBlt(byte[] src, int sw, int sh, int sx, int sy, byte[] dst, int dw, int dh, int dx, int dy, int w, int h,
            int rop);

    /** Whether this display's layer is copied to the screen every 250 ms; on at the start. */
    void setAutoRefresh(boolean on);

    /**
     * Accepted without effect: the period is always 250 ms.
     *
     * @return 0
     */
    int setAutoRefreshPeriod(int period);
}
