package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecimalsTest {
    @ParameterizedTest
    @CsvSource({"0, 3, 0", "1, 3, 1", "-1, 3, -1", "0.5, 3, 0.5", "0.0005, 3, 0.001", "0.00049, 3, 0", "-0.0004, 3, 0",
            "12.3456, 2, 12.35",
        "100.10, 2, 100.1", "1234567.891, 3, 1234567.891", "0.05, 2, 0.05", "2, 0, 2", "0.000000001, 9, 0.000000001"})
    void textHasAtMostThatManyPlacesAndNoTrailingZeros(double value, int places, String expected) {
        assertThat(Decimals.text(value, places)).isEqualTo(expected);
    }

    @Test
    void numbersThatJsonDoesNotKnowAreNull() {
        assertThat(Decimals.text(Double.NaN, 3)).isEqualTo("null");
        assertThat(Decimals.text(Double.POSITIVE_INFINITY, 3)).isEqualTo("null");
    }

    @Test
    void secondsAreCutToMicroseconds() {
        assertThat(Decimals.seconds(1_234_567_899L)).isEqualTo("1.234567");
        assertThat(Decimals.seconds(60_000_000_000L)).isEqualTo("60");
        assertThat(Decimals.seconds(2_000_000L)).isEqualTo("0.002");
    }
}
