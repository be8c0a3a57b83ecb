package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PacerTest {
    private static final long SECOND = 1_000_000_000;

    @ParameterizedTest
    @CsvSource({"1, 2000", "0.1, 200", "2.5, 5000", "100, 200000"})
    void simulatedTimePassesAtItsSpeed(double speed, long millis) {
        Pacer pacer = new Pacer(speed);
        pacer.restart(5 * SECOND, SECOND);
        assertThat(pacer.due(7 * SECOND)).isEqualTo(SECOND + millis * 1_000_000);
    }

    @Test
    void atMaximumSpeedEverythingIsDueUntilTheRunShouldRest() {
        Pacer pacer = new Pacer(Speed.MAX);
        assertThat(pacer.reached(SECOND, 12)).isFalse();
        assertThat(pacer.due(SECOND)).isEqualTo(Pacer.REST_NANOS);
    }

    @Test
    void aRunRestsAfterTenHoursAndAfterTenMore() {
        Pacer pacer = new Pacer(100);
        pacer.restart(0, Pacer.REST_NANOS - SECOND);
        assertThat(pacer.due(SECOND)).isEqualTo(Pacer.REST_NANOS);
        assertThat(pacer.reached(SECOND, Pacer.REST_NANOS)).isTrue();
        assertThat(pacer.reached(SECOND, Pacer.REST_NANOS)).isFalse();
        pacer.restart(2 * SECOND, Pacer.REST_NANOS);
        assertThat(pacer.due(3 * SECOND)).isEqualTo(Pacer.REST_NANOS + 100 * SECOND);
        assertThat(pacer.reached(3 * SECOND, 2 * Pacer.REST_NANOS)).isTrue();
        pacer.begin(4 * SECOND);
        assertThat(pacer.due(Long.MAX_VALUE / 200)).as("of a new run").isEqualTo(Pacer.REST_NANOS);
    }

    @Test
    void anotherSpeedGoesOnFromWhereTheRunIs() {
        Pacer pacer = new Pacer(1);
        pacer.restart(0, 0);
        pacer.setSpeed(10, 2 * SECOND, 2 * SECOND);
        assertThat(pacer.due(3 * SECOND)).isEqualTo(12 * SECOND);
        assertThat(pacer.speed()).isEqualTo(10);
    }

    @Test
    void aSmallLagIsCaughtUpAndALargeOneDropped() {
        Pacer pacer = new Pacer(1);
        pacer.restart(0, 0);
        pacer.reached(SECOND, SECOND - 150_000_000);
        assertThat(pacer.due(SECOND)).isEqualTo(SECOND);
        pacer.reached(SECOND, SECOND - 150_000_001);
        assertThat(pacer.due(SECOND)).isEqualTo(SECOND - 150_000_001);
        assertThat(pacer.due(2 * SECOND)).isEqualTo(2 * SECOND - 150_000_001);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "0.1, 0.1", "100x, 100", "2.5x, 2.5", "max, Infinity"})
    void speedsAreNumbersOrMax(String text, double speed) {
        assertThat(Speed.parse(text)).contains(speed);
    }

    @ParameterizedTest
    @CsvSource({"0", "0.09", "100.1", "-1", "1e1", "x", "maximum", "NaN", "Infinity"})
    void otherSpeedsAreNone(String text) {
        assertThat(Speed.parse(text)).isEmpty();
    }
}
