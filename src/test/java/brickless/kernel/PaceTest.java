package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PaceTest {
    private static final long HOST = 5_000;
    private static final long STEP = 100;

    private final Pace pace = new Pace(STEP, HOST);

    @Test
    void aStepIsDueWhenItsTimeHasCome() {
        assertThat(pace.due(HOST + 99)).isZero();
        assertThat(pace.untilNextStep(HOST + 99)).isEqualTo(1);
        assertThat(pace.due(HOST + 100)).isEqualTo(1);
        assertThat(pace.step()).isEqualTo(100);
        assertThat(pace.due(HOST + 100)).isZero();
        assertThat(pace.untilNextStep(HOST + 100)).isEqualTo(100);
    }

    @Test
    void timeNeverPassesAStepThatWasNotMade() {
        assertThat(pace.now(HOST + 40)).isEqualTo(40);
        assertThat(pace.now(HOST + 170)).isEqualTo(100);
        pace.step();
        assertThat(pace.now(HOST + 170)).isEqualTo(170);
    }

    @Test
    void aShortDelayIsCaughtUp() {
        assertThat(pace.due(HOST + 10 * STEP)).isEqualTo(10);
    }

    @Test
    void aLongDelayIsDroppedBeyondTheLongestBurst() {
        long late = HOST + 1_000 * STEP;
        assertThat(pace.due(late)).isEqualTo(Pace.LONGEST_BURST);
        for (int i = 0; i < Pace.LONGEST_BURST; i++) {
            pace.step();
        }
        assertThat(pace.due(late)).isZero();
        assertThat(pace.now(late)).isEqualTo(Pace.LONGEST_BURST * STEP);
        assertThat(pace.due(late + STEP)).isEqualTo(1);
    }
}
