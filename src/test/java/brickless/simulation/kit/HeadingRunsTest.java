package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.Headings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Headings that {@code GyroDirectionFinder} derives on its own thread. */
class HeadingRunsTest {
    private static Printed lines;

    @BeforeAll
    static void run() {
        try (Run run = Kit.run(Headings.class, Kit.EMPTY, Kit.BENCH, UnaryOperator.identity())) {
            lines = Kit.printed(run);
        }
    }

    @Test
    void theRateIsAddedUp() {
        assertThat(lines.number("degrees")).isCloseTo(90, offset(1.0));
        assertThat(lines.number("velocity")).isEqualTo(90);
        assertThat(lines.number("acceleration")).isZero();
    }

    @Test
    void cartesianHeadingsCountTheOtherWayFromTheirZero() {
        assertThat(lines.number("cartesian")).isCloseTo(-45, offset(1.0));
        assertThat(lines.number("set")).isEqualTo(30);
    }

    @Test
    void ratesBelowOneDegreePerSecondCountAsRest() {
        assertThat(lines.number("deadBand")).isZero();
    }

    @Test
    void headingsAreNotReducedToACircle() {
        assertThat(lines.number("unbounded")).isEqualTo(700);
    }

    @Test
    void calibrationTakesItsTimeAndAsksTheGyroscopeOnce() {
        assertThat(lines.number("calibration")).isEqualTo(2600);
        assertThat(lines.number("calibration", 1)).isEqualTo(1);
        assertThat(lines.number("calibrations")).as("with one more finder that calibrates at first").isEqualTo(2);
    }
}
