package brickless.device.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MoveRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Golden vectors measured on the published library, and properties of all plans. */
class MovePlanTest {
    private static final int ENDLESS = MotorRegulation.NO_LIMIT;

    private static MovePlan plan(float p, float u, float speed, int acceleration, int limit) {
        return MovePlan.of(new MoveRequest(speed, acceleration, limit, true), p, u);
    }

    @ParameterizedTest(name = "from p={0} u={1} to {2}")
    @CsvSource({
        // p, u, limit, t1, t2, t3, position at t1, position at t2, velocity at t1
        "0, 0, 360, 60, 1000, 1060, 10.8, 349.2, 360",
        "0, 0, -90, 60, 249, 309, -10.8, -79.2, -360",
        "0, 0, 10, 40, 40, 80, 5.0, 5.0, 244.9",
        "100, 360, 50, 120, 228, 288, 100, 60.8, -360",
        "100, 360, 105, 91, 91, 122, 107.9, 107.9, -186.5",
        "100, 360, 300, 0, 525, 585, 100, 289.2, 360",
        "100, -360, 200, 120, 367, 427, 100, 189.2, 360"})
    void limitedMovesMatchThePublishedLibrary(float p, float u, int limit, int t1, int t2, int t3, double atT1,
            double atT2, double v) {
        MovePlan plan = plan(p, u, 360, 6000, limit);
        assertThat(plan.cruiseMillis()).isEqualTo(t1);
        assertThat(plan.brakingMillis()).isEqualTo(t2);
        assertThat(plan.endMillis()).isEqualTo(t3);
        assertThat((double) plan.position(t1)).isCloseTo(atT1, offset(0.06));
        assertThat((double) plan.position(t2)).isCloseTo(atT2, offset(0.06));
        assertThat((double) plan.velocity(t1)).isCloseTo(v, offset(0.06));
        assertThat(plan.position(t3)).isEqualTo(limit);
    }

    @Test
    void moveToTheOwnPositionIsEmpty() {
        MovePlan plan = plan(0, 0, 360, 6000, 0);
        assertThat(plan.empty()).isTrue();
        assertThat(plan.target()).isZero();
    }

    @Test
    void standingStillNeedsNoAcceleration() {
        MovePlan plan = plan(30, 0, 0, 0, 30);
        assertThat(plan.empty()).isTrue();
        assertThat(plan.target()).isEqualTo(30);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0, 360", "5, 0", "NaN, 6000", "NaN, 0"})
    void withoutAccelerationOrSpeedAPlanStillHasNumbers(float speed, int acceleration) {
        for (int limit : new int[] {0, 7, 300, ENDLESS, -ENDLESS}) {
            for (float velocity : new float[] {0, 30}) {
                MovePlan plan = plan(7, velocity, speed, acceleration, limit);
                assertThat(plan.position(100)).as("limit %d, velocity %f", limit, velocity).isFinite();
                assertThat(plan.velocity(100)).isFinite();
                assertThat(plan.position(1e9)).isFinite();
            }
        }
        assertThat(plan(7, 0, 0, 0, 7).target()).as("at rest").isEqualTo(7);
    }

    @Test
    void endlessMoveSpeedsUpAndRunsOn() {
        MovePlan plan = plan(0, 0, 360, 6000, ENDLESS);
        assertThat(plan.cruiseMillis()).isEqualTo(60);
        assertThat((double) plan.position(60)).isCloseTo(10.8, offset(1e-4));
        assertThat((double) plan.position(60_060)).isCloseTo(10.8 + 60 * 360, offset(0.1));
    }

    @Test
    void endlessMoveBackwardIsTheMirrorImage() {
        MovePlan plan = plan(0, 0, 360, 6000, -ENDLESS);
        assertThat(plan.velocity(1000)).isEqualTo(-360);
    }

    @Test
    void fasterSpeedDuringAnEndlessMoveTakesTheDifferenceOnly() {
        MovePlan plan = plan(100, 360, 720, 6000, ENDLESS);
        assertThat(plan.cruiseMillis()).isBetween(59, 60);
        assertThat((double) plan.position(60)).isCloseTo(132.4, offset(0.8));
    }

    @Test
    void stoppingTakesTheBrakingDistance() {
        MovePlan plan = plan(100, 360, 0, 1000, ENDLESS);
        assertThat(plan.endMillis()).isEqualTo(360);
        assertThat((double) plan.position(360)).isCloseTo(164.8, offset(1e-3));
        assertThat((double) plan.velocity(180)).isCloseTo(180, offset(1e-3));
    }

    @Test
    void stoppingFromBackwardMotionEndsBehind() {
        MovePlan plan = plan(0, -360, 0, 1000, ENDLESS);
        assertThat((double) plan.position(1000)).isCloseTo(-64.8, offset(1e-3));
    }

    @Test
    void shiftingTheFrameMovesEveryPosition() {
        MovePlan plan = plan(0, 0, 360, 6000, 360);
        MovePlan same = plan(0, 0, 360, 6000, 360);
        plan.shift(100);
        for (int millis : new int[] {0, 30, 60, 500, 1030, 1060, 2000}) {
            assertThat((double) plan.position(millis)).isCloseTo(same.position(millis) - 100.0, offset(1e-3));
        }
    }

    /**
     * From many starts to many targets: positions never jump by more than the truncation of times allows, and the end
     * is the target.
     */
    @Test
    void plansAreContinuousAndEndAtTheirTarget() {
        float[] starts = {-720, -360, -50, 0, 50, 360, 720};
        int[] limits = {-2000, -100, -7, 0, 3, 45, 360, 5000};
        int[] accelerations = {200, 1000, 6000};
        for (int index = 0; index < starts.length * limits.length * accelerations.length; index++) {
            float u = starts[index % starts.length];
            int limit = limits[index / starts.length % limits.length];
            int a = accelerations[index / starts.length / limits.length];
            MovePlan plan = plan(0, u, 500, a, limit);
            float last = 0;
            for (int t = 0; t <= plan.endMillis() + 5; t++) {
                float now = plan.position(t);
                assertThat(Math.abs(now - last)).as("index %d at %d ms", index, t).isLessThan(3.2f);
                last = now;
            }
            assertThat(plan.position(plan.endMillis())).as("index %d", index).isEqualTo(limit);
        }
    }
}
