package brickless.kernel.hooks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.MissingFormatArgumentException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Formats in English, from shortest decimals, with plain line ends. */
class FormatHooksTest {
    private static String format(String format, Object... arguments) {
        return FormatHooks.format(format, arguments);
    }

    @ParameterizedTest
    @CsvSource({"0.125, 0.13", "-0.125, -0.13", "0.375, 0.38", "1.005, 1.01", "2.0E-323, 0.00", "1234.5, 1234.50"})
    void decimalsAreRoundedHalfUpFromTheirShortestText(double value, String text) {
        assertThat(format("%.2f", value)).isEqualTo(text);
    }

    @Test
    void floatsAreFormattedAsTheDoubleTheyAre() {
        assertThat(format("%.10f", 0.1f)).isEqualTo("0.1000000015");
    }

    @Test
    void specialValuesKeepTheirTexts() {
        assertThat(format("%f %.1f %5.1f|%e", Double.NaN, -0.0, Double.POSITIVE_INFINITY, 12345.678))
                .isEqualTo("NaN -0.0 Infinity|1.234568e+04");
    }

    @Test
    void stringConversionsUseTheCommonText() {
        assertThat(format("%s|%10s|%-4s|%S", 4 * Double.MIN_VALUE, 1.5, 2f, "up"))
                .isEqualTo("2.0E-323|       1.5|2.0 |UP");
    }

    @Test
    void indexesFlagsAndLineEndsWork() {
        assertThat(format("%2$d %1$s %<s|%05d%%%n", 3, 7)).isEqualTo("7 3 3|00003%\n");
    }

    @Test
    void missingArgumentsAreRefused() {
        assertThatThrownBy(() -> format("%d %d", 1)).isInstanceOf(MissingFormatArgumentException.class);
    }
}
