package lejos.hardware.video;

import lejos.hardware.lcd.GraphicsLCD;

/** A picture in the format YUYV 4:2:2: for each pair of pixels the bytes Y₀, U, Y₁, V. */
public class YUYVImage {
    private static final int BYTES_PER_PIXEL = 2;
    private static final int BYTES_PER_PAIR = 4;
    private static final int BYTE = 0xff;

    private final byte[] pixels;
    private final int width;
    private final int height;

    /** Wraps memory, which stays shared. */
    public YUYVImage(byte[] pix, int w, int h) {
        pixels = pix;
        width = w;
        height = h;
    }

    /** A picture of zeros. */
    public YUYVImage(int w, int h) {
        this(new byte[w * h * BYTES_PER_PIXEL], w, h);
    }

    /** Number of pixels. */
    public int getNumPixels() {
        return width * height;
    }

    /** Width in pixels. */
    public int getWidth() {
        return width;
    }

    /** Height in pixels. */
    public int getHeight() {
        return height;
    }

    /** Brightness of a pixel as a signed byte: 128 to 255 come out as −128 to −1, as in leJOS. */
    public int getY(int x, int y) {
        return pixels[(y * width + x) * BYTES_PER_PIXEL];
    }

    /** Blue difference of a pixel as a signed byte. */
    public int getU(int x, int y) {
        return pixels[pair(x, y) + 1];
    }

    /** Red difference of a pixel as a signed byte. */
    public int getV(int x, int y) {
        return pixels[pair(x, y) + 3];
    }

    private int pair(int x, int y) {
        return (y * width + x) / 2 * BYTES_PER_PAIR;
    }

    /** Mean brightness, 0 to 255. */
    public int getMeanY() {
        long sum = 0;
        for (int i = 0; i < getNumPixels() * BYTES_PER_PIXEL; i += BYTES_PER_PIXEL) {
            sum += pixels[i] & BYTE;
        }
        return (int) (sum / getNumPixels());
    }

    /**
     * Draws the picture: pixels brighter than the threshold white, the others black.
     *
     * @param xoff left edge on the display
     * @param yoff upper edge on the display
     * @param threshold brightness, 0 to 255
     */
    public void display(GraphicsLCD gfx, int xoff, int yoff, int threshold) {
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                gfx.setPixel(x + xoff, y + yoff, (getY(x, y) & BYTE) > threshold ? 0 : 1);
            }
        }
    }
}
