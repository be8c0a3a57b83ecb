package lejos.internal.ev3;

/**
 * Combines rectangles of two bitmaps bit by bit. Each result bit is {@code (d & ((s & A) ^ B)) ^ ((s & C) ^ D)}, where
 * A to D are the four bytes of the operation from the highest to the lowest.
 */
final class RasterOperation {
    private final byte[] source;
    private final int sourceRowBytes;
    private final byte[] target;
    private final int targetRowBytes;
    private final int a;
    private final int b;
    private final int c;
    private final int d;

    private RasterOperation(byte[] source, int sourceWidth, byte[] target, int targetWidth, int operation) {
        this.source = source;
        this.sourceRowBytes = (sourceWidth + 7) / 8;
        this.target = target;
        this.targetRowBytes = (targetWidth + 7) / 8;
        this.a = operation >>> 24;
        this.b = operation >>> 16 & 0xff;
        this.c = operation >>> 8 & 0xff;
        this.d = operation & 0xff;
    }

    /**
     * See {@link lejos.hardware.lcd.CommonLCD#bitBlt(byte[], int, int, int, int, byte[], int, int, int, int, int, int,
     * int)}.
     */
    static void bitBlt(byte[] src, int sw, int sh, int sx, int sy, byte[] dst, int dw, int dh, int dx, int dy, int w,
            int h, int rop) {
        int left = Math.max(0, -dx);
        int top = Math.max(0, -dy);
        if (sx + left < 0 || sy + top < 0) {
            return;
        }
        int width = Math.min(w, Math.min(sw - sx, dw - dx)) - left;
        int height = Math.min(h, Math.min(sh - sy, dh - dy)) - top;
        if (width > 0 && height > 0) {
            byte[] untouched = src == dst ? src.clone() : src;
            new RasterOperation(untouched, sw, dst, dw, rop)
                    .run(sx + left, sy + top, dx + left, dy + top, width, height);
        }
    }

    private void run(int sx, int sy, int dx, int dy, int width, int height) {
        for (int y = 0; y < height; y++) {
            int x = 0;
            while (x < width) {
                int bit = dx + x & 7;
                int count = Math.min(8 - bit, width - x);
                int mask = (1 << count) - 1 << bit;
                int index = (dy + y) * targetRowBytes + (dx + x >> 3);
                int s = readsSource() ? sourceBits(sx + x, sy + y, count) << bit : 0;
                int old = target[index];
                int result = old & (s & a ^ b) ^ s & c ^ d;
                target[index] = (byte) (old & ~mask | result & mask);
                x += count;
            }
        }
    }

    private boolean readsSource() {
        return (a | c) != 0;
    }

    private int sourceBits(int x, int y, int count) {
        int index = y * sourceRowBytes + (x >> 3);
        int bit = x & 7;
        int bits = (source[index] & 0xff) >> bit;
        if (bit + count > 8) {
            bits |= (source[index + 1] & 0xff) << 8 - bit;
        }
        return bits;
    }
}
