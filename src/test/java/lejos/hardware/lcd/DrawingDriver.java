package lejos.hardware.lcd;

import java.util.Random;
import lejos.internal.ev3.EV3GraphicsLCD;

/** Draws a picture that the index decides, with whatever classes it is linked with. */
final class DrawingDriver {
    static final int WIDTH = 61;
    static final int HEIGHT = 40;
    static final int KINDS = 10;
    private static final int[] OPERATIONS = {
        0x00000000, 0xff000000, 0xff00ff00, 0x0000ff00, 0xffff0000, 0x00ff0000, 0x00ffff00, 0xffffff00,
        0xffffffff, 0x00ffffff, 0x00ff00ff, 0xffff00ff, 0x0000ffff, 0xff00ffff, 0xff0000ff, 0x000000ff
    };

    private final Random random;
    private final byte[] memory = new byte[(WIDTH + 7) / 8 * HEIGHT];
    private final GraphicsLCD surface = new EV3GraphicsLCD(memory, WIDTH, HEIGHT);

    private DrawingDriver(int index) {
        random = new Random(index);
        random.nextBytes(memory);
    }

    /** The picture's memory; the pixels beyond the width are not part of it. */
    static byte[] play(int index) {
        DrawingDriver driver = new DrawingDriver(index);
        driver.draw(index % KINDS);
        driver.clearPadding();
        return driver.memory;
    }

    private void draw(int kind) {
        surface.setStrokeStyle(random.nextInt(2));
        surface.setColor(random.nextBoolean() ? 0 : 0xffffff);
        surface.setFont(new Stripes());
        boolean translatedTwiceInTheOriginal = kind == 1;
        if (!translatedTwiceInTheOriginal) {
            surface.translate(random.nextInt(9) - 4, random.nextInt(9) - 4);
        }
        switch (kind) {
            case 0 -> surface.drawLine(x(), y(), x(), y());
            case 1 -> surface.drawRect(x(), y(), size(), size());
            case 2 -> surface.fillRect(x(), y(), size(), size());
            case 3 -> surface.drawString("a\u00e4bc", x(), y(), anchor(), random.nextBoolean());
            case 4 -> surface.drawSubstring("abcabc", random.nextInt(3), random.nextInt(4), x(), y(), anchor());
            case 5 -> surface.drawImage(picture(), x(), y(), anchor());
            case 6 -> surface.drawRegion(picture(), random.nextInt(6), random.nextInt(6), 12, 7, transform(), x(), y(),
                    anchor());
            case 7 -> surface.drawRegionRop(picture(), random.nextInt(9), random.nextInt(9), size(), size(), x(), y(),
                    anchor(), operation());
            case 8 -> surface.bitBlt(picture().getData(), 21, 15, random.nextInt(24) - 2, random.nextInt(18) - 2,
                    memory, WIDTH, HEIGHT, x(), y(), size(), size(), operation());
            default -> copyWithin(random.nextInt(20));
        }
    }

    /** To the left or straight up and down only: to the right the original spoils overlapping copies. */
    private void copyWithin(int toX) {
        surface.bitBlt(memory, WIDTH, HEIGHT, toX + random.nextInt(20), random.nextInt(20), memory, WIDTH, HEIGHT,
                toX, random.nextInt(20), size(), size(), operation());
    }

    /** None, or a mirrored quarter turn: the others the original shifts by a pixel. */
    private int transform() {
        return new int[] {0, 4}[random.nextInt(2)];
    }

    private int x() {
        return random.nextInt(WIDTH + 20) - 10;
    }

    private int y() {
        return random.nextInt(HEIGHT + 20) - 10;
    }

    private int size() {
        return random.nextInt(30) - 2;
    }

    /** One horizontal and one vertical bit, or none. */
    private int anchor() {
        int horizontal = new int[] {0, 1, 4, 8}[random.nextInt(4)];
        int vertical = new int[] {0, 2, 16, 32}[random.nextInt(4)];
        return horizontal | vertical;
    }

    private int operation() {
        return OPERATIONS[random.nextInt(OPERATIONS.length)];
    }

    private Image picture() {
        byte[] data = new byte[3 * 15];
        random.nextBytes(data);
        return new Image(21, 15, data);
    }

    private void clearPadding() {
        for (int y = 0; y < HEIGHT; y++) {
            memory[(y + 1) * ((WIDTH + 7) / 8) - 1] &= (byte) ((1 << WIDTH % 8) - 1);
        }
    }

    /** A font of three characters that are easy to tell apart. */
    private static final class Stripes extends Font {
        private static final long serialVersionUID = 1L;

        Stripes() {
            super(new byte[] {0x55, 0x3a, 0x12, 0x7f, 0x01, 0x66}, 5, 3, 2, 5, 3, 'a');
        }
    }
}
