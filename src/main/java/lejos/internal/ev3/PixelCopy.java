package lejos.internal.ev3;

import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.Image;

/** Makes turned and mirrored copies of a part of a bitmap. */
final class PixelCopy {
    private final byte[] source;
    private final int sourceWidth;
    private final int sourceHeight;
    private final int width;
    private final int height;
    private final int transform;

    private PixelCopy(byte[] source, int sourceWidth, int sourceHeight, int width, int height, int transform) {
        this.source = source;
        this.sourceWidth = sourceWidth;
        this.sourceHeight = sourceHeight;
        this.width = width;
        this.height = height;
        this.transform = transform;
    }

    /** The part at (x, y) of the given size, transformed; pixels outside the source are white. */
    static Image of(byte[] source, int sourceWidth, int sourceHeight, int x, int y, int width, int height,
            int transform) {
        return new PixelCopy(source, sourceWidth, sourceHeight, width, height, transform).from(x, y);
    }

    private Image from(int left, int top) {
        boolean turned = transform >= GraphicsLCD.TRANS_MIRROR_ROT270;
        int resultWidth = turned ? height : width;
        int resultHeight = turned ? width : height;
        int rowBytes = (resultWidth + 7) / 8;
        byte[] result = new byte[rowBytes * resultHeight];
        for (int y = 0; y < resultHeight; y++) {
            for (int x = 0; x < resultWidth; x++) {
                if (black(left + sourceX(x, y), top + sourceY(x, y))) {
                    result[y * rowBytes + (x >> 3)] |= (byte) (1 << (x & 7));
                }
            }
        }
        return new Image(resultWidth, resultHeight, result);
    }

    private int sourceX(int x, int y) {
        return switch (transform) {
            case GraphicsLCD.TRANS_MIRROR, GraphicsLCD.TRANS_ROT180 -> width - 1 - x;
            case GraphicsLCD.TRANS_ROT90, GraphicsLCD.TRANS_MIRROR_ROT270 -> y;
            case GraphicsLCD.TRANS_ROT270, GraphicsLCD.TRANS_MIRROR_ROT90 -> width - 1 - y;
            default -> x;
        };
    }

    private int sourceY(int x, int y) {
        return switch (transform) {
            case GraphicsLCD.TRANS_MIRROR_ROT180, GraphicsLCD.TRANS_ROT180 -> height - 1 - y;
            case GraphicsLCD.TRANS_ROT90, GraphicsLCD.TRANS_MIRROR_ROT90 -> height - 1 - x;
            case GraphicsLCD.TRANS_ROT270, GraphicsLCD.TRANS_MIRROR_ROT270 -> x;
            default -> y;
        };
    }

    private boolean black(int x, int y) {
        boolean inside = x >= 0 && x < sourceWidth && y >= 0 && y < sourceHeight;
        return inside && (source[y * ((sourceWidth + 7) / 8) + (x >> 3)] >> (x & 7) & 1) != 0;
    }
}
