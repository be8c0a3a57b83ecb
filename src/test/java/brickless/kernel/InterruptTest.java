package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class InterruptTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    private final Object lock = new Object();

    /** A way to block that an interrupt ends by InterruptedException. */
    private enum Blocking {
        SLEEP {
            @Override
            void block(Robot robot, Object lock) throws Exception {
                robot.sleepMillis(1_000);
            }
        },
        WAIT {
            @Override
            void block(Robot robot, Object lock) throws Exception {
                robot.locked(lock, () -> robot.kernel.monitorWait(lock, 0));
            }
        },
        TIMED_WAIT {
            @Override
            void block(Robot robot, Object lock) throws Exception {
                robot.locked(lock, () -> robot.kernel.monitorWait(lock, 1_000 * Robot.MILLI));
            }
        },
        JOIN {
            @Override
            void block(Robot robot, Object lock) throws Exception {
                robot.kernel.join(robot.startDaemon("endless", () -> robot.sleepMillis(1_000_000)), 0);
            }
        },
        SIGNAL {
            @Override
            void block(Robot robot, Object lock) throws Exception {
                robot.kernel.newSignal().awaitInterruptibly(1_000 * Robot.MILLI);
            }
        };

        abstract void block(Robot robot, Object lock) throws Exception;
    }

    static Stream<Arguments> backendsAndBlockings() {
        return Backends.available().stream()
                .flatMap(backend -> Stream.of(Blocking.values()).map(blocking -> Arguments.of(backend, blocking)));
    }

    @ParameterizedTest
    @MethodSource("backendsAndBlockings")
    void anInterruptEndsTheBlockingAndClearsTheFlag(BackendChoice backend, Blocking blocking) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread victim = robot.start("victim", () -> {
                try {
                    blocking.block(robot, lock);
                } catch (InterruptedException e) {
                    robot.note("interrupted, flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false));
                }
            });
            robot.sleepMillis(10);
            robot.kernel.interrupt(victim);
        });
        assertThat(robot.log).containsExactly("10 interrupted, flag false");
    }

    @ParameterizedTest
    @MethodSource("backendsAndBlockings")
    void anInterruptBeforehandEndsTheBlockingAtOnce(BackendChoice backend, Blocking blocking) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.kernel.interrupt(robot.kernel.currentThread());
            try {
                blocking.block(robot, lock);
            } catch (InterruptedException e) {
                robot.note("interrupted, flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false));
            }
        });
        assertThat(robot.log).containsExactly("0 interrupted, flag false");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aRunningThreadOnlyGetsTheFlag(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread victim = robot.start("victim", () -> {
                Thread me = robot.kernel.currentThread();
                while (!robot.kernel.interrupted(me, false)) {
                    robot.work(Costs.BACK_EDGE_NANOS);
                }
                robot.note("flag " + robot.kernel.interrupted(me, true) + " " + robot.kernel.interrupted(me, true));
            });
            robot.sleepMillis(15);
            robot.kernel.interrupt(victim);
        });
        // The victim's slice ended at 10.5 ms, so main gets the processor as soon as it wakes, at 15.5 ms.
        assertThat(robot.log).containsExactly("15 flag true false");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void parkReturnsOnInterruptAndKeepsTheFlag(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread victim = robot.start("victim", () -> {
                robot.kernel.park(0);
                robot.kernel.park(0);
                robot.note("flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false));
            });
            robot.sleepMillis(10);
            robot.kernel.interrupt(victim);
        });
        assertThat(robot.log).containsExactly("10 flag true");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void enteringAMonitorIsNotInterrupted(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> robot.locked(lock, () -> {
            Thread victim = robot.start("victim", () -> robot.locked(lock,
                    () -> robot.note("in, flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false))));
            robot.sleepMillis(5);
            robot.kernel.interrupt(victim);
            robot.sleepMillis(5);
        }));
        assertThat(robot.log).containsExactly("10 in, flag true");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aNotifiedThreadReturnsNormallyAndKeepsALaterInterrupt(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread victim = robot.start("victim", () -> robot.locked(lock, () -> {
                robot.kernel.monitorWait(lock, 0);
                robot.note("flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false));
            }));
            robot.sleepMillis(5);
            robot.locked(lock, () -> {
                robot.kernel.monitorNotify(lock, false);
                robot.kernel.interrupt(victim);
            });
        });
        assertThat(robot.log).containsExactly("5 flag true");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anInterruptedWaiterDoesNotUseUpANotification(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread first = robot.start("first", () -> waitAndNote(robot));
            robot.start("second", () -> waitAndNote(robot));
            robot.sleepMillis(5);
            robot.locked(lock, () -> {
                robot.kernel.interrupt(first);
                robot.kernel.monitorNotify(lock, false);
            });
        });
        assertThat(robot.log).containsExactlyInAnyOrder("6 first interrupted", "6 second notified");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anUninterruptibleSignalKeepsTheFlagAndGoesOnWaiting(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Processor.Signal signal = robot.kernel.newSignal();
            Thread victim = robot.start("victim", () -> {
                boolean raised = signal.await(0);
                robot.note(raised + ", flag " + robot.kernel.interrupted(robot.kernel.currentThread(), false));
            });
            robot.sleepMillis(5);
            robot.kernel.interrupt(victim);
            robot.kernel.at(20 * Robot.MILLI, signal::raise);
        });
        assertThat(robot.log).isEqualTo(List.of("20 true, flag true"));
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void interruptingAThreadThatIsNotAliveDoesNothing(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread thread = Robot.thread("t", () -> robot.note("flag "
                    + robot.kernel.interrupted(robot.kernel.currentThread(), false)));
            robot.kernel.interrupt(thread);
            robot.kernel.start(thread);
            robot.kernel.join(thread, 0);
            robot.kernel.interrupt(thread);
            robot.note("after " + robot.kernel.interrupted(thread, false));
        });
        assertThat(robot.log).containsExactly("0 flag false", "0 after false");
    }

    private void waitAndNote(Robot robot) throws Exception {
        robot.locked(lock, () -> {
            String name = robot.kernel.currentThread().getName();
            try {
                robot.kernel.monitorWait(lock, 0);
                robot.note(name + " notified");
            } catch (InterruptedException e) {
                robot.note(name + " interrupted");
            }
        });
    }
}
