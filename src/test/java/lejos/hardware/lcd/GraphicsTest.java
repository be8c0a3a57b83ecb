package lejos.hardware.lcd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

/** Shapes on a picture in memory, against pixels worked out by hand. */
class GraphicsTest {
    private static final int SIZE = 64;

    private final Image image = Image.createImage(SIZE, SIZE);
    private final GraphicsLCD g = image.getGraphics();

    /** The rows from the first to the last with ink, cut to the columns with ink. */
    private String ink() {
        int left = SIZE;
        int right = -1;
        int top = SIZE;
        int bottom = -1;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                if (g.getPixel(x, y) == 1) {
                    left = Math.min(left, x);
                    right = Math.max(right, x);
                    top = Math.min(top, y);
                    bottom = Math.max(bottom, y);
                }
            }
        }
        StringBuilder rows = new StringBuilder((right - left + 1) + "x" + (bottom - top + 1) + " at " + left + ","
                + top);
        for (int y = top; y <= bottom; y++) {
            rows.append('\n');
            for (int x = left; x <= right; x++) {
                rows.append(g.getPixel(x, y) == 1 ? '#' : '.');
            }
        }
        return rows.toString();
    }

    private int count() {
        return (int) ink().chars().filter(c -> c == '#').count();
    }

    @Test
    void lineIncludesBothEnds() {
        g.drawLine(2, 3, 7, 5);
        assertThat(ink()).isEqualTo("""
                6x3 at 2,3
                ##....
                ..##..
                ....##""".stripIndent());
    }

    @Test
    void dottedLineOfTwentyOnePixelsShowsEleven() {
        g.setStrokeStyle(GraphicsLCD.DOTTED);
        g.drawLine(0, 0, 20, 0);
        assertThat(count()).isEqualTo(11);
        assertThat(ink()).endsWith("##.#.#.#.#.#.#.#.#.#");
    }

    @Test
    void rectangleOutlineIsOnePixelLargerThanItsSizeAndFillingIsNot() {
        g.drawRect(1, 2, 3, 2);
        assertThat(ink()).isEqualTo("""
                4x3 at 1,2
                ####
                #..#
                ####""");
        g.clear();
        g.fillRect(1, 2, 3, 2);
        assertThat(ink()).isEqualTo("""
                3x2 at 1,2
                ###
                ###""");
    }

    @Test
    void flatRectanglesAreLinesAndNegativeOnesNothing() {
        g.drawRect(5, 5, 4, 0);
        assertThat(ink()).isEqualTo("5x1 at 5,5\n#####");
        g.clear();
        g.drawRect(5, 5, 0, 0);
        assertThat(ink()).isEqualTo("1x1 at 5,5\n#");
        g.drawRect(9, 9, -1, 4);
        g.fillRect(9, 9, 0, 4);
        g.fillRect(9, 9, 4, -2);
        g.drawArc(9, 9, -1, 4, 0, 360);
        g.fillArc(9, 9, 4, -1, 0, 360);
        g.drawRoundRect(9, 9, -4, 4, 2, 2);
        assertThat(count()).isEqualTo(1);
    }

    @Test
    void smallCircleHasTheExpectedPixels() {
        g.drawArc(0, 0, 6, 6, 0, 360);
        assertThat(ink()).isEqualTo("""
                7x7 at 0,0
                ..###..
                .#...#.
                #.....#
                #.....#
                #.....#
                .#...#.
                ..###..""");
    }

    @Test
    void circleOfFortySpansFortyOnePixelsAndIsSymmetrical() {
        g.drawArc(3, 4, 40, 40, 0, 360);
        assertThat(ink()).startsWith("41x41 at 3,4\n");
        for (int y = 0; y <= 40; y++) {
            for (int x = 0; x <= 40; x++) {
                int pixel = g.getPixel(3 + x, 4 + y);
                assertThat(g.getPixel(3 + 40 - x, 4 + y)).isEqualTo(pixel);
                assertThat(g.getPixel(3 + y, 4 + x)).isEqualTo(pixel);
            }
        }
    }

    @Test
    void flatEllipseKeepsToItsBox() {
        g.drawArc(3, 4, 40, 20, 0, 360);
        assertThat(ink()).startsWith("41x21 at 3,4\n");
        g.clear();
        g.fillArc(3, 4, 40, 5, 0, 360);
        assertThat(ink()).startsWith("41x6 at 3,4\n");
    }

    @Test
    void anglesCountFromThreeOClockCounterClockwise() {
        g.drawArc(0, 0, 6, 6, 0, 90);
        assertThat(ink()).isEqualTo("""
                4x4 at 3,0
                ##..
                ..#.
                ...#
                ...#""");
        g.clear();
        g.drawArc(0, 0, 6, 6, 0, -90);
        assertThat(ink()).isEqualTo("""
                4x4 at 3,3
                ...#
                ...#
                ..#.
                ##..""");
    }

    @Test
    void filledQuarterIsASectorWithTheCentre() {
        g.fillArc(0, 0, 6, 6, 90, 90);
        assertThat(ink()).isEqualTo("""
                4x4 at 0,0
                ..##
                .###
                ####
                ####""");
    }

    @Test
    void filledCircleCoversItsOutline() {
        g.fillArc(5, 5, 31, 24, 0, 360);
        String filled = ink();
        g.drawArc(5, 5, 31, 24, 0, 360);
        assertThat(ink()).isEqualTo(filled);
    }

    @Test
    void roundedRectangleLosesItsCorners() {
        g.drawRoundRect(0, 0, 9, 6, 4, 4);
        assertThat(ink()).isEqualTo("""
                10x7 at 0,0
                .########.
                #........#
                #........#
                #........#
                #........#
                #........#
                .########.""");
    }

    @Test
    void everyShapeIsTranslatedOnce() {
        g.translate(10, 20);
        g.translate(1, 2);
        assertThat(g.getTranslateX()).isEqualTo(11);
        assertThat(g.getTranslateY()).isEqualTo(22);
        Runnable[] shapes = {
            () -> g.drawRect(0, 0, 3, 3), () -> g.fillRect(0, 0, 4, 4), () -> g.drawRoundRect(0, 0, 3, 3, 0, 0),
            () -> g.fillArc(0, 0, 3, 3, 0, 360), () -> g.drawArc(0, 0, 3, 3, 0, 360), () -> g.drawLine(0, 0, 3, 3)
        };
        for (Runnable shape : shapes) {
            g.clear();
            shape.run();
            assertThat(ink()).startsWith("4x4 at 11,22\n");
        }
    }

    @Test
    void whiteErases() {
        g.fillRect(0, 0, 10, 10);
        g.setColor(GraphicsLCD.WHITE);
        g.drawLine(0, 0, 9, 9);
        g.setColor(200, 0, 0);
        g.fillRect(5, 0, 2, 2);
        g.setColor(0, 0, 0);
        g.drawLine(0, 0, 0, 0);
        assertThat(count()).isEqualTo(100 - 10 - 4 + 1);
    }

    @Test
    void setPixelTakesOneAsBlackAndEverythingElseAsWhite() {
        g.setPixel(3, 3, 1);
        g.setPixel(4, 3, 7);
        assertThat(ink()).isEqualTo("1x1 at 3,3\n#");
        g.setPixel(3, 3, GraphicsLCD.BLACK);
        assertThat(g.getPixel(3, 3)).isZero();
        g.setPixel(-1, 0, 1);
        g.setPixel(0, SIZE, 1);
        assertThat(g.getPixel(-1, 0)).isZero();
        assertThat(g.getPixel(0, SIZE)).isZero();
    }

    @Test
    void badArgumentsAreRefused() {
        assertThatThrownBy(() -> g.setColor(0, 256, 0)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("bad color value");
        assertThatThrownBy(() -> g.setColor(-1, 0, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> g.setStrokeStyle(2)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> g.drawSubstring("abc", 2, 5, 0, 0, 0))
                .isInstanceOf(StringIndexOutOfBoundsException.class);
        assertThatThrownBy(() -> g.drawChars(new char[3], 2, 5, 0, 0, 0))
                .isInstanceOf(ArrayIndexOutOfBoundsException.class);
        assertThatThrownBy(() -> g.drawString(null, 0, 0, 0)).isInstanceOf(NullPointerException.class);
    }
}
