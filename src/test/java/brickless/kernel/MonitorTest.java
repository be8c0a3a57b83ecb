package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class MonitorTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    private final Object lock = new Object();

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aSecondThreadWaitsUntilTheMonitorIsLeft(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> robot.locked(lock, () -> {
            Thread other = robot.start("other", () -> robot.locked(lock, () -> robot.note("other in")));
            robot.sleepMillis(20);
            robot.note("main leaves, other is " + robot.kernel.state(other));
        }));
        assertThat(robot.log).containsExactly("20 main leaves, other is BLOCKED", "20 other in");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void monitorsAreReentrant(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.locked(lock, () -> robot.locked(lock, () -> assertThat(robot.kernel.holdsMonitor(lock)).isTrue()));
            assertThat(robot.kernel.holdsMonitor(lock)).isFalse();
        });
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void onlyTheOwnerMayLeaveWaitOrNotify(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            assertThatThrownBy(() -> robot.kernel.monitorExit(lock))
                    .isInstanceOf(IllegalMonitorStateException.class);
            assertThatThrownBy(() -> robot.kernel.monitorWait(lock, 0))
                    .isInstanceOf(IllegalMonitorStateException.class);
            assertThatThrownBy(() -> robot.kernel.monitorNotify(lock, true))
                    .isInstanceOf(IllegalMonitorStateException.class);
            assertThatThrownBy(() -> robot.kernel.monitorEnter(null)).isInstanceOf(NullPointerException.class);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theCriticalSectionIsNeverSharedUnderManySchedules(BackendChoice backend) {
        for (int seed = 0; seed < 30; seed++) {
            Robot robot = new Robot(Robot.settings(backend).withScheduleSeed(seed));
            int[] inside = new int[2];
            ProgramEnd end = robot.run(() -> {
                for (int t = 0; t < 4; t++) {
                    robot.start("t" + t, () -> {
                        for (int i = 0; i < 20; i++) {
                            robot.locked(lock, () -> {
                                assertThat(++inside[0]).isEqualTo(1);
                                robot.work(5_000);
                                inside[0]--;
                                inside[1]++;
                            });
                        }
                    });
                }
            });
            assertThat(end.kind()).as("seed %d: %s", seed, end).isEqualTo(ProgramEnd.Kind.EXITED);
            assertThat(inside[1]).isEqualTo(80);
        }
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theThreadThatLeavesMayEnterAgainBeforeTheOneItWoke(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.kernel.monitorEnter(lock);
            robot.start("other", () -> robot.locked(lock, () -> robot.note("other")));
            robot.sleepMillis(5);
            robot.kernel.monitorExit(lock);
            robot.locked(lock, () -> robot.note("main again"));
        });
        assertThat(robot.log).containsExactly("5 main again", "5 other");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aThreadThatWaitsForABusyMonitorDoesNotStarve(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(1_000 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            robot.startDaemon("greedy", () -> {
                while (true) {
                    robot.locked(lock, () -> robot.sleepMillis(10));
                }
            });
            robot.sleepMillis(5);
            robot.locked(lock, () -> robot.note("got it"));
        });
        // Bypassed at 10, 20, 30, 40 and 50 ms after the greedy thread's first sleep, then handed over.
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(robot.log).containsExactly("50 got it");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void enteringAFreeMonitorCostsHalfAMicrosecond(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            for (int i = 0; i < 4; i++) {
                robot.locked(new Object(), () -> { });
            }
        });
        assertThat(end.timeNanos()).isEqualTo(4 * Costs.MONITOR_ENTER_NANOS);
    }
}
