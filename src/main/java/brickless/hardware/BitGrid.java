package brickless.hardware;

/**
 * A small bitmap in the byte order of the screen: rows of whole bytes, lowest bit leftmost. Not shared while it is
 * written.
 */
final class BitGrid {
    private final int width;
    private final int height;
    private final byte[] bytes;

    BitGrid(int width, int height) {
        this.width = width;
        this.height = height;
        this.bytes = new byte[(width + 7) / 8 * height];
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    byte[] toBytes() {
        return bytes.clone();
    }

    boolean get(int x, int y) {
        return (bytes[index(x, y)] >> (x & 7) & 1) != 0;
    }

    void set(int x, int y) {
        bytes[index(x, y)] |= (byte) (1 << (x & 7));
    }

    private int index(int x, int y) {
        return y * ((width + 7) / 8) + (x >> 3);
    }

    /**
     * The bitmap at twice the size, its diagonal steps smoothed: a quarter pixel takes the colour of the two neighbours
     * it touches when these agree and their opposites differ. Cells of {@code cellWidth} pixels do not see each other.
     */
    BitGrid doubled(int cellWidth) {
        BitGrid result = new BitGrid(2 * width, 2 * height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int quarter = 0; quarter < 4; quarter++) {
                    int right = quarter & 1;
                    int lower = quarter >> 1;
                    if (quarterPixel(x, y, 2 * right - 1, 2 * lower - 1, cellWidth)) {
                        result.set(2 * x + right, 2 * y + lower);
                    }
                }
            }
        }
        return result;
    }

    private boolean quarterPixel(int x, int y, int dx, int dy, int cellWidth) {
        boolean side = neighbour(x, y, dx, 0, cellWidth);
        boolean vertical = neighbour(x, y, 0, dy, cellWidth);
        boolean corner = side == vertical
                && side != neighbour(x, y, -dx, 0, cellWidth)
                && vertical != neighbour(x, y, 0, -dy, cellWidth);
        return corner ? side : get(x, y);
    }

    private boolean neighbour(int x, int y, int dx, int dy, int cellWidth) {
        int column = x % cellWidth + dx;
        int row = y + dy;
        return column >= 0 && column < cellWidth && row >= 0 && row < height && get(x + dx, row);
    }
}
