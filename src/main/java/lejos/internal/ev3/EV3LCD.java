package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import java.util.Arrays;
import lejos.hardware.lcd.CommonLCD;

/** A surface to draw on: a layer of the screen, or a picture in memory. */
public class EV3LCD implements CommonLCD {
    /** Width of the screen in pixels. */
    public static final int SCREEN_WIDTH = 178;
    /** Height of the screen in pixels. */
    public static final int SCREEN_HEIGHT = 128;
    /** Period of the automatic copy to the screen in milliseconds. */
    public static final int DEFAULT_REFRESH_PERIOD = 250;
    /** Bytes per row of the screen. */
    protected static final int SCREEN_MEM_WIDTH = 23;
    /** Bytes of the screen. */
    protected static final int LCD_BUFFER_LENGTH = SCREEN_MEM_WIDTH * SCREEN_HEIGHT;
    /** Name of the layer that programs draw on. */
    static final String PROGRAM_LAYER = "LCD";

    /** The memory that is drawn into. */
    protected byte[] displayBuf;
    /** The layer, null when this draws on a picture. */
    protected EV3LCDManager.LCDLayer layer;

    private final int width;
    private final int height;

    /** Draws on a layer of the screen. */
    public EV3LCD(String layerName) {
        this.layer = EV3LCDManager.getLocalLCDManager().getLayer(layerName);
        this.displayBuf = layer.getDisplay();
        this.width = SCREEN_WIDTH;
        this.height = SCREEN_HEIGHT;
    }

    /** Draws on the layer that programs share. */
    public EV3LCD() {
        this(PROGRAM_LAYER);
    }

    EV3LCD(byte[] picture, int width, int height) {
        this.displayBuf = picture;
        this.width = width;
        this.height = height;
    }

    @Override
    public void bitBlt(byte[] src, int sw, int sh, int sx, int sy, int dx, int dy, int w, int h, int rop) {
        bitBlt(src, sw, sh, sx, sy, displayBuf, width, height, dx, dy, w, h, rop);
    }

    @Override
    public void bitBlt(byte[] src, int sw, int sh, int sx, int sy, byte[] dst, int dw, int dh, int dx, int dy, int w,
            int h, int rop) {
        RasterOperation.bitBlt(src, sw, sh, sx, sy, dst, dw, dh, dx, dy, w, h, rop);
        spend((Math.min(w, dw) + 7) / 8 * Math.min(h, dh));
    }

    /** Fills a rectangle of this surface, clipped. */
    final void fill(int x, int y, int w, int h, int rop) {
        bitBlt(null, width, height, 0, 0, x, y, w, h, rop);
    }

    /** Reports the work of a drawing call, so that it takes time. */
    void spend(int pixels) {
        announceDrawing();
        BrickAccess.present().ifPresent(brick -> brick.screen().drawn(Math.max(0, pixels)));
    }

    final void announceDrawing() {
        if (layer != null) {
            EV3LCDManager.getLocalLCDManager().aboutToDraw();
        }
    }

    /** Makes the surface white. */
    public void clearDisplay() {
        clear();
    }

    /** Same as {@link #refresh}. */
    public void asyncRefresh() {
        refresh();
    }

    /** The present time in milliseconds: copying takes no time that a program could wait for. */
    public long getRefreshCompleteTime() {
        return System.currentTimeMillis();
    }

    /** Returns at once. */
    public void asyncRefreshWait() {
        // Nothing to wait for: refresh() copies before it returns.
    }

    @Override
    public void refresh() {
        if (layer != null) {
            layer.refresh();
        }
    }

    @Override
    public void clear() {
        Arrays.fill(displayBuf, (byte) 0);
        spend(displayBuf.length);
    }

    @Override
    public byte[] getDisplay() {
        return displayBuf;
    }

    @Override
    public int setAutoRefreshPeriod(int period) {
        return 0;
    }

    @Override
    public void setAutoRefresh(boolean on) {
        if (layer != null) {
            layer.setAutoRefresh(on);
        }
    }

    /** Sets one pixel: 1 = black, anything else white; off-screen pixels are ignored. */
    public void setPixel(int x, int y, int color) {
        spend(1);
        plot(x, y, color == 1);
    }

    /** One pixel: 1 = black, 0 = white or off-screen. */
    public int getPixel(int x, int y) {
        spend(1);
        return contains(x, y) ? displayBuf[index(x, y)] >> (x & 7) & 1 : 0;
    }

    /** Sets one pixel without spending time; off-screen pixels are ignored. */
    final void plot(int x, int y, boolean black) {
        if (contains(x, y)) {
            int index = index(x, y);
            int bit = 1 << (x & 7);
            displayBuf[index] = (byte) (black ? displayBuf[index] | bit : displayBuf[index] & ~bit);
        }
    }

    private boolean contains(int x, int y) {
        return x >= 0 && x < width && y >= 0 && y < height;
    }

    private int index(int x, int y) {
        return y * ((width + 7) / 8) + (x >> 3);
    }

    @Override
    public void setContrast(int contrast) {
        // The EV3's contrast is fixed.
    }

    @Override
    public byte[] getHWDisplay() {
        return EV3LCDManager.getLocalLCDManager().getHWDisplay();
    }

    @Override
    public int getWidth() {
        return width;
    }

    @Override
    public int getHeight() {
        return height;
    }
}
