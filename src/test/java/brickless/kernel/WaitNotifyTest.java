package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class WaitNotifyTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    private final Object lock = new Object();

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void notifyWakesTheLongestWaiterAndNotifyAllTheRest(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            startWaiters(robot, 3);
            robot.sleepMillis(10);
            robot.locked(lock, () -> robot.kernel.monitorNotify(lock, false));
            robot.sleepMillis(10);
            robot.locked(lock, () -> robot.kernel.monitorNotify(lock, true));
        });
        assertThat(robot.log).containsExactly("11 w0", "21 w1", "21 w2");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aNotifiedThreadGoesOnOnlyWhenTheMonitorIsFree(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            startWaiters(robot, 1);
            robot.sleepMillis(10);
            robot.locked(lock, () -> {
                robot.kernel.monitorNotify(lock, false);
                robot.sleepMillis(10);
                robot.note("leaves");
            });
        });
        assertThat(robot.log).containsExactly("20 leaves", "20 w0");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void waitingReleasesAllEntriesAndTakesThemAllBack(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> robot.locked(lock, () -> robot.locked(lock, () -> {
            robot.start("notifier", () -> robot.locked(lock, () -> {
                robot.note("notifies");
                robot.kernel.monitorNotify(lock, false);
            }));
            robot.kernel.monitorWait(lock, 0);
            robot.kernel.monitorExit(lock);
            robot.note("still inside " + robot.kernel.holdsMonitor(lock));
            robot.kernel.monitorEnter(lock);
        })));
        assertThat(robot.log).containsExactly("0 notifies", "0 still inside true");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aTimedWaitEndsOnTime(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> robot.locked(lock, () -> {
            robot.kernel.monitorWait(lock, 25 * Robot.MILLI);
            robot.note("timed out");
        }));
        assertThat(robot.log).containsExactly("25 timed out");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aTimedOutWaiterStillNeedsTheMonitor(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.start("waiter", () -> robot.locked(lock, () -> {
                robot.kernel.monitorWait(lock, 5 * Robot.MILLI);
                robot.note("waiter");
            }));
            robot.sleepMillis(1);
            robot.locked(lock, () -> robot.sleepMillis(29));
        });
        assertThat(robot.log).containsExactly("30 waiter");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aNotifyInTimeCancelsTheTimeout(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.start("waiter", () -> robot.locked(lock, () -> {
                robot.kernel.monitorWait(lock, 10 * Robot.MILLI);
                robot.note("notified");
                robot.kernel.monitorWait(lock, 10 * Robot.MILLI);
                robot.note("timed out");
            }));
            robot.sleepMillis(5);
            robot.locked(lock, () -> robot.kernel.monitorNotify(lock, true));
        });
        assertThat(robot.log).containsExactly("5 notified", "15 timed out");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aNotificationWithoutWaiterIsLost(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> robot.locked(lock, () -> {
            robot.kernel.monitorNotify(lock, true);
            robot.kernel.monitorWait(lock, 0);
        }));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theEndOfAThreadNotifiesWhoeverWaitsInIt(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread worker = robot.start("worker", () -> robot.sleepMillis(8));
            robot.locked(worker, () -> robot.kernel.monitorWait(worker, 0));
            robot.note("worker is " + robot.kernel.state(worker));
        });
        assertThat(robot.log).containsExactly("8 worker is TERMINATED");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void producerAndConsumerExchangeEverythingUnderManySchedules(BackendChoice backend) {
        for (int seed = 0; seed < 20; seed++) {
            Robot robot = new Robot(Robot.settings(backend).withScheduleSeed(seed));
            int[] box = new int[2];
            ProgramEnd end = robot.run(() -> {
                robot.start("consumer", () -> {
                    for (int i = 1; i <= 30; i++) {
                        int expected = i;
                        robot.locked(lock, () -> {
                            while (box[0] == 0) {
                                robot.kernel.monitorWait(lock, 0);
                            }
                            assertThat(box[0]).isEqualTo(expected);
                            box[0] = 0;
                            box[1]++;
                            robot.kernel.monitorNotify(lock, true);
                        });
                    }
                });
                for (int i = 1; i <= 30; i++) {
                    int value = i;
                    robot.locked(lock, () -> {
                        while (box[0] != 0) {
                            robot.kernel.monitorWait(lock, 0);
                        }
                        box[0] = value;
                        robot.kernel.monitorNotify(lock, true);
                    });
                    robot.work(3_000);
                }
            });
            assertThat(end.kind()).as("seed %d: %s", seed, end).isEqualTo(ProgramEnd.Kind.EXITED);
            assertThat(box[1]).isEqualTo(30);
        }
    }

    private void startWaiters(Robot robot, int count) {
        for (int i = 0; i < count; i++) {
            String name = "w" + i;
            robot.start(name, () -> robot.locked(lock, () -> {
                robot.kernel.monitorWait(lock, 0);
                robot.note(name);
            }));
        }
    }
}
