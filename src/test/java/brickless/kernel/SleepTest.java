package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SleepTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aSleeperWakesExactlyOnTimeWithoutContextSwitch(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            for (int i = 0; i < 1_000; i++) {
                robot.sleepMillis(3);
            }
        });
        assertThat(end.timeNanos()).isEqualTo(3_000 * Robot.MILLI);
        assertThat(robot.kernel.contextSwitches()).isZero();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void sleepersWakeByTime(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            for (int millis : new int[] {30, 10, 20}) {
                robot.start("t" + millis, () -> {
                    robot.sleepMillis(millis);
                    robot.note("t" + millis);
                });
            }
        });
        // Each start takes half a millisecond; the threads run when the main thread has ended, at 1.5 ms.
        assertThat(robot.log).containsExactly("11 t10", "21 t20", "31 t30");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void sleepersOfOneTimeWakeInOrderOfGoingToSleep(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            for (int i = 0; i < 5; i++) {
                int number = i;
                robot.start("t" + i, () -> {
                    robot.sleepMillis(7);
                    robot.note("" + number);
                });
            }
        });
        assertThat(robot.log).containsExactly("9 0", "9 1", "9 2", "9 3", "9 4");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aBusyThreadKeepsTheProcessorUntilItsSliceEnds(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.start("sleeper", () -> {
                robot.sleepMillis(1);
                robot.note("awake");
            });
            robot.sleepMillis(0);
            robot.work(50 * Robot.MILLI);
        });
        // Main gives the sleeper a turn by sleep(0), 0.1 ms after 0.5 ms for the start, and then has a slice of 10
        // ms.
        assertThat(robot.log).containsExactly("10 awake");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void negativeTimesAreRefused(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            assertThatThrownBy(() -> robot.kernel.sleep(-1)).isInstanceOf(IllegalArgumentException.class);
            Thread other = robot.start("other", () -> { });
            assertThatThrownBy(() -> robot.kernel.join(other, -1)).isInstanceOf(IllegalArgumentException.class);
        });
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anEndlessSleepEndsAtTheLimit(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(Robot.MILLI));
        ProgramEnd end = robot.run(() -> robot.kernel.sleep(Long.MAX_VALUE));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
        assertThat(end.timeNanos()).isEqualTo(Robot.MILLI);
    }
}
