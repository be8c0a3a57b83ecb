package brickless.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.physics.ArenaSettings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Halving the step changes no trial by more than a few millimetres, half a degree or two steps. */
class StepAccuracyTest {
    @ParameterizedTest(name = "{0} within {1}")
    @CsvSource({"STRAIGHT,1", "TURN,0.5", "CURVE,2", "STALL,4", "WALL,1", "PUSH,1", "ROW,1", "CONTEST,1", "CREEP,0.01",
        "GYRO,0.6", "SONAR,1.5"})
    void halvingTheStepHardlyChangesAnything(StepTrials trial, double tolerance) {
        double[] usual = trial.run(ArenaSettings.of(false), 0);
        double[] half = trial.run(new ArenaSettings(false, ArenaSettings.DEFAULT_STEP_NANOS / 2), 0);
        for (int i = 0; i < usual.length; i++) {
            assertThat(usual[i]).isCloseTo(half[i], offset(tolerance));
        }
    }
}
