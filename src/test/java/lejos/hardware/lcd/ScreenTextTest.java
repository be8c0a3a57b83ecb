package lejos.hardware.lcd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.device.panel.PanelBench;
import brickless.device.panel.ScreenText;
import java.nio.charset.StandardCharsets;
import java.util.MissingFormatWidthException;
import lejos.hardware.ev3.LocalEV3;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class ScreenTextTest {
    private PanelBench bench;

    private static String text() {
        return ScreenText.read(LCD.getDisplay());
    }

    private static int ink() {
        int count = 0;
        for (byte b : LCD.getDisplay()) {
            count += Integer.bitCount(b & 0xff);
        }
        return count;
    }

    @Test
    void stringsLandInTheirCellsAndReplaceWhatWasThere() {
        LCD.drawString("Hello, brick!", 2, 1);
        LCD.drawString("J", 2, 1);
        LCD.drawString("x=-1.5", 0, 7);
        assertThat(text()).isEqualTo("\n  Jello, brick!\n\n\n\n\n\nx=-1.5");
    }

    @Test
    void screenIsCopiedEveryQuarterSecondAndOnRequest() {
        LCD.drawString("late", 0, 0);
        assertThat(bench.screen.asText()).isEmpty();
        bench.processor().charge(251_000_000);
        assertThat(bench.screen.asText()).isEqualTo("late");
        LCD.drawString("soon", 0, 0);
        LCD.refresh();
        assertThat(bench.screen.asText()).isEqualTo("soon");
        assertThat(bench.events()).containsExactly("screen", "screen");
        assertThat(ScreenText.read(LCD.getHWDisplay())).isEqualTo("soon");
    }

    @Test
    void callsThatConcernTheNxtScreenDoNothing() {
        LCD.setContrast(50);
        assertThat(LCD.setAutoRefreshPeriod(7)).isZero();
        bench.processor().charge(5_000_000);
        assertThat(LCD.getRefreshCompleteTime()).as("now, on a clock that begins in 2015").isPositive();
        double before = bench.millis();
        LCD.asyncRefreshWait();
        assertThat(bench.millis() - before).isLessThan(1);
        assertThat(ink()).isZero();
    }

    @Test
    void nullIsNoText() {
        assertThatThrownBy(() -> LCD.drawString(null, 0, 0)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void withoutAutoRefreshOnlyRequestsCopy() {
        LCD.setAutoRefresh(false);
        LCD.drawString("x", 0, 0);
        bench.processor().charge(1_000_000_000);
        assertThat(bench.screen.asText()).isEmpty();
        LCD.asyncRefresh();
        assertThat(bench.screen.asText()).isEqualTo("x");
    }

    @Test
    void textIsCutAtTheRightEdgeWithTheFirstPixelsOfColumnEighteen() {
        LCD.drawString("0123456789abcdefgHIJ", 0, 0);
        assertThat(text()).isEqualTo("0123456789abcdefg");
        assertThat(LCD.getPixel(171, 1)).as("left stem of H, column 1 of its cell").isEqualTo(1);
        LCD.drawString("xyz", -1, 1);
        assertThat(text()).endsWith("\nyz");
    }

    @Test
    void cellsOffTheScreenDrawNothing() {
        LCD.drawString("ghost", 0, 8);
        LCD.drawString("ghost", 0, -1);
        LCD.drawChar('g', 20, 0);
        assertThat(ink()).isZero();
    }

    @Test
    void charactersWithoutAGlyphAreBlankInStringsAndIgnoredAlone() {
        LCD.drawString("abc", 0, 0);
        LCD.drawString("\u00e9\n", 0, 0);
        assertThat(text()).isEqualTo("  c");
        LCD.drawChar('\n', 2, 0);
        assertThat(text()).isEqualTo("  c");
        LCD.drawChar('d', 2, 0);
        assertThat(text()).isEqualTo("  d");
        assertThatThrownBy(() -> LCD.drawString(null, 0, 0)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void invertedTextIsWhiteOnBlack() {
        LCD.drawString("I ", 0, 0);
        int letter = ink();
        LCD.drawString("I ", 0, 0, true);
        assertThat(ink()).isEqualTo(2 * 160 - letter);
        LCD.drawString("I", 0, 0);
        LCD.clear(1, 0, 1);
        assertThat(text()).isEqualTo("I");
    }

    @Test
    void numbersAreDecimalAndPadded() {
        LCD.drawInt(-42, 0, 0);
        LCD.drawInt(7, 4, 0, 1);
        LCD.drawInt(123456, 4, 0, 2);
        assertThat(text()).isEqualTo("-42\n   7\n123456");
        assertThatThrownBy(() -> LCD.drawInt(5, 0, 0, 0)).isInstanceOf(MissingFormatWidthException.class);
    }

    @Test
    void scrollingMovesRowsUp() {
        for (int row = 0; row < 8; row++) {
            LCD.drawInt(row, 0, row);
        }
        LCD.scroll();
        assertThat(text()).isEqualTo("1\n2\n3\n4\n5\n6\n7");
    }

    @Test
    void clearingRowsCellsAndEverything() {
        for (int row = 0; row < 3; row++) {
            LCD.drawString("abcdef", 0, row);
        }
        LCD.clear(1);
        LCD.clear(2, 2, 3);
        assertThat(text()).isEqualTo("abcdef\n\nab   f");
        LCD.clear();
        assertThat(ink()).isZero();
    }

    @Test
    void smallAndLargeFontsHaveTheirOwnGrids() {
        TextLCD small = LocalEV3.get().getTextLCD(Font.getSmallFont());
        TextLCD large = LocalEV3.get().getTextLCD(Font.getLargeFont());
        assertThat(new int[] {small.getTextWidth(), small.getTextHeight(), large.getTextWidth(), large.getTextHeight()})
                .containsExactly(29, 16, 8, 4);
        small.drawString("29 columns by 16 rows of text", 0, 15);
        assertThat(ScreenText.readSmall(LCD.getDisplay())).endsWith("29 columns by 16 rows of text");
        large.drawString("A", 7, 3);
        assertThat(LCD.getPixel(140 + 2, 96 + 26)).isEqualTo(1);
    }

    @Test
    void graphicsTextIsTransparentAndAnchored() {
        GraphicsLCD g = LocalEV3.get().getGraphicsLCD();
        g.drawString("ab", 170, 128, GraphicsLCD.RIGHT | GraphicsLCD.BOTTOM);
        g.drawString("c", 15, 14, GraphicsLCD.HCENTER | GraphicsLCD.BASELINE);
        g.drawString("d", 30, 16, GraphicsLCD.VCENTER);
        assertThat(text()).isEqualTo(" c\n   d\n\n\n\n\n\n               ab");
        g.drawString("-", 30, 16, 0);
        g.setColor(GraphicsLCD.WHITE);
        g.drawString("-", 30, 16, 0);
        g.drawString("c", 10, 0, 0);
        assertThat(LCD.getPixel(12, 6)).isZero();
    }

    @Test
    void printedTextWrapsScrollsAndObeysControls() {
        LCDOutputStream out = new LCDOutputStream();
        for (byte b : "one\ntwo\tx\rT\n0123456789abcdefghi\n".getBytes(StandardCharsets.US_ASCII)) {
            out.write(b);
        }
        assertThat(text()).isEqualTo("one\nTwo     x\n0123456789abcdefg\nhi");
        for (byte b : "4\n5\n6\n7\n".getBytes(StandardCharsets.US_ASCII)) {
            out.write(b);
        }
        assertThat(text()).as("last line is blank after the final newline")
                .isEqualTo("Two     x\n0123456789abcdefg\nhi\n4\n5\n6\n7");
        out.write('\f');
        out.write('!');
        assertThat(text()).isEqualTo("!");
    }

    @Test
    void drawingATextLineTakesHalfAMillisecond() {
        double before = bench.millis();
        LCD.drawString("seventeen columns", 0, 0);
        assertThat(bench.millis() - before).isBetween(0.45, 0.6);
    }

    @Test
    void fontConstantsAndSizesAreThoseOfLejos() {
        assertThat(LCD.getSystemFont()).hasSize(1920).isSameAs(Font.getDefaultFont().glyphs);
        assertThat(Font.getFont(0, 0, Font.SIZE_SMALL)).isSameAs(Font.getSmallFont());
        assertThat(Font.getFont(0, 0, Font.SIZE_LARGE)).isSameAs(Font.getLargeFont());
        assertThat(Font.getFont(0, 0, 99)).isSameAs(Font.getDefaultFont());
        Font large = Font.getLargeFont();
        assertThat(new int[] {large.width, large.height, large.base, large.glyphWidth, large.glyphCount,
                large.firstChar, large.glyphs.length})
                .containsExactly(20, 32, 28, 20, 96, 32, 7680);
        assertThat(Font.getSmallFont().stringWidth("four")).isEqualTo(24);
        assertThat(Font.getDefaultFont().getBaselinePosition()).isEqualTo(14);
        assertThat(Font.getSmallFont().getHeight()).isEqualTo(8);
    }
}
