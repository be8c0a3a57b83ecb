package brickless.world;

/**
 * The pixels of an image that lies on the floor. Sampled without smoothing (nearest pixel), so every machine reads the
 * same colour. Immutable.
 */
public final class Texture {
    private final int width;
    private final int height;
    private final int[] argb;
    private final double[] toPixels;

    /**
     * Creates a texture.
     *
     * @param width pixels per row
     * @param height rows
     * @param argb pixels row by row, 0xAARRGGBB, not premultiplied
     * @param toPixels a, b, c, d, e, f of the map from metres to pixels: column = a·x + c·y + e, row = b·x + d·y + f
     */
    public Texture(int width, int height, int[] argb, double... toPixels) {
        if (width < 1 || height < 1 || argb.length != (long) width * height || toPixels.length != 6) {
            throw new IllegalArgumentException("texture of " + width + " x " + height + " pixels with " + argb.length
                    + " values");
        }
        this.width = width;
        this.height = height;
        this.argb = argb.clone();
        this.toPixels = toPixels.clone();
    }

    /** Colour at a point in metres as 0xAARRGGBB; points outside the image read its nearest pixel. */
    public int argbAt(double x, double y) {
        double column = toPixels[0] * x + toPixels[2] * y + toPixels[4];
        double row = toPixels[1] * x + toPixels[3] * y + toPixels[5];
        int c = (int) Math.max(0, Math.min(width - 1, Math.floor(column)));
        int r = (int) Math.max(0, Math.min(height - 1, Math.floor(row)));
        return argb[r * width + c];
    }
}
