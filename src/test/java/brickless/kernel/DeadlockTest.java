package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import handwritten.LockOrder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class DeadlockTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    /** Longer than a time slice, so that the other thread runs between the two locks. */
    private static final long PAUSE = 15 * Robot.MILLI;

    private final Object lock = new Object();

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aDeadlockIsReportedInTheProgramsTerms(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> new LockOrder(robot.kernel).start(1, PAUSE));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.dump().lines()).satisfiesExactly(
                // two starts of 0.5 ms, two pauses, four entries of 0.5 µs
                line -> assertThat(line).isEqualTo("deadlock at 31.002 ms"),
                line -> assertThat(line).matches(
                        "\"left\" BLOCKED on java.lang.StringBuilder held by \"right\" at LockOrder.java:\\d+"),
                line -> assertThat(line).matches("    at handwritten.LockOrder.takeBoth\\(LockOrder.java:\\d+\\)"),
                line -> assertThat(line).matches("    at handwritten.LockOrder.lambda.*"),
                line -> assertThat(line).matches(
                        "\"right\" BLOCKED on java.lang.Object held by \"left\" at LockOrder.java:\\d+"),
                line -> assertThat(line).matches("    at handwritten.LockOrder.takeBoth\\(LockOrder.java:\\d+\\)"),
                line -> assertThat(line).matches("    at handwritten.LockOrder.lambda.*"));
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aCycleOfMonitorsIsFoundWhileOtherThreadsGoOn(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(1_000 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            new LockOrder(robot.kernel).start(1, PAUSE);
            robot.spin();
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.timeNanos()).isLessThan(100 * Robot.MILLI);
        assertThat(end.dump()).contains("\"main\" RUNNABLE").contains("held by \"left\"").contains("held by \"right\"");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void waitingForeverForANotificationIsADeadlockEvenIfTheWorldStepsOn(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend), time -> { });
        ProgramEnd end = robot.run(() -> {
            robot.sleepMillis(5);
            robot.locked(lock, () -> robot.kernel.monitorWait(lock, 0));
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.timeNanos() / Robot.MILLI).isEqualTo(5);
        assertThat(end.dump()).contains("\"main\" WAITING on java.lang.Object");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void parkingForeverIsADeadlock(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        assertThat(robot.run(() -> robot.kernel.park(0)).kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void waitingForADeviceIsNoDeadlock(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(500 * Robot.MILLI), time -> { });
        Processor.Signal button = robot.kernel.newSignal();
        ProgramEnd end = robot.run(() -> button.await(0));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void waitingForADeviceThatNothingCanRaiseIsADeadlock(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        Processor.Signal button = robot.kernel.newSignal();
        ProgramEnd end = robot.run(() -> button.await(0));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.dump()).contains("\"main\" WAITING for a device");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aThreadThatWaitsForADeviceMayStillWakeTheOthers(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend), time -> { });
        Processor.Signal button = robot.kernel.newSignal();
        ProgramEnd end = robot.run(() -> {
            robot.kernel.at(300 * Robot.MILLI, button::raise);
            Thread main = robot.kernel.currentThread();
            robot.startDaemon("listener", () -> {
                button.await(0);
                robot.kernel.unpark(main);
            });
            robot.kernel.park(0);
            robot.note("woken");
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(robot.log).containsExactly("300 woken");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aSleeperMayStillWakeTheOthers(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.startDaemon("late", () -> {
                robot.sleepMillis(60_000);
                robot.locked(lock, () -> robot.kernel.monitorNotify(lock, false));
            });
            robot.locked(lock, () -> robot.kernel.monitorWait(lock, 0));
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aCycleThroughJoinIsADeadlockAfterTenSeconds(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(60_000 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            Thread main = robot.kernel.currentThread();
            robot.startDaemon("clock", () -> {
                while (true) {
                    robot.sleepMillis(100);
                }
            });
            robot.kernel.join(robot.start("child", () -> robot.kernel.join(main, 0)), 0);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.timeNanos()).isEqualTo(2 * Costs.THREAD_START_NANOS + DeadlockDetector.GRACE_NANOS);
        assertThat(end.dump()).contains("\"main\" WAITING for the end of \"child\"");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aCycleThroughJoinMayBeBrokenByAnInterrupt(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(60_000 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            Thread main = robot.kernel.currentThread();
            Thread child = robot.start("child", () -> {
                try {
                    robot.kernel.join(main, 0);
                } catch (InterruptedException e) {
                    robot.note("interrupted");
                }
            });
            robot.start("rescuer", () -> {
                robot.sleepMillis(9_000);
                robot.kernel.interrupt(child);
                robot.sleepMillis(9_000);
            });
            robot.kernel.join(child, 0);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(robot.log).containsExactly("9001 interrupted");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void joiningWithATimeoutOrJoiningOneselfIsNoCycle(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(40_000 * Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            Thread main = robot.kernel.currentThread();
            robot.startDaemon("child", () -> robot.kernel.join(main, 30_000 * Robot.MILLI));
            robot.startDaemon("clock", () -> robot.sleepMillis(90_000));
            robot.kernel.join(main, 0);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aHookThatNeedsALockOfTheExitingThreadIsADeadlock(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.addShutdownHook(Robot.thread("hook", () -> robot.locked(lock, () -> { })));
            robot.locked(lock, () -> robot.kernel.exit(0));
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.DEADLOCK);
        assertThat(end.dump()).contains("\"main\" WAITING for shutdown hooks").contains("\"hook\" BLOCKED");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theDumpCanBeAskedForAtAnyTime(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.start("other", () -> robot.sleepMillis(5));
            robot.sleepMillis(1);
            robot.log.add(robot.kernel.dump("threads"));
        });
        assertThat(robot.log).containsExactly("threads at 1.500 ms\n\"main\" RUNNABLE\n\"other\" TIMED_WAITING\n");
    }
}
