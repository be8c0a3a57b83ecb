package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.hooks.ProgramKilled;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ProgramEndTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theEndOfTheLastThreadIsExitZero(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> robot.start("last", () -> robot.sleepMillis(40)));
        long time = Costs.THREAD_START_NANOS + 40 * Robot.MILLI;
        assertThat(end).isEqualTo(new ProgramEnd(ProgramEnd.Kind.EXITED, time, 0, null, ""));
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void exitFromAnyThreadEndsAll(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.start("spinner", robot::spin);
            robot.start("sleeper", () -> robot.sleepMillis(1_000_000));
            robot.start("exiter", () -> {
                robot.sleepMillis(100);
                robot.kernel.exit(3);
            });
            robot.kernel.park(0);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(end.status()).isEqualTo(3);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void exitDoesNotReturnAndRunsFinallyBlocksOfNobodyElse(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            try {
                throw new IllegalStateException("first");
            } catch (IllegalStateException e) {
                try {
                    robot.note("catch");
                } finally {
                    robot.kernel.exit(7);
                }
                robot.note("not reached");
            }
        });
        assertThat(end.status()).isEqualTo(7);
        assertThat(robot.log).containsExactly("0 catch");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void afterTheEndEveryEntryThrowsAgainAndAgain(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(10 * Robot.MILLI));
        List<Throwable> caught = new ArrayList<>();
        Object lock = new Object();
        ProgramEnd end = robot.run(() -> {
            List<Robot.Body> entries = List.of(robot::spin, () -> robot.kernel.charge(1), () -> robot.kernel.sleep(1),
                    robot.kernel::yieldProcessor, () -> robot.kernel.monitorEnter(lock), () -> robot.kernel.park(0),
                    () -> robot.kernel.join(robot.kernel.currentThread(), 0), robot.kernel::nanoTime,
                    () -> robot.kernel.exit(1), () -> robot.kernel.halt(1), () -> robot.kernel.newSignal().await(1));
            robot.kernel.monitorEnter(this);
            for (Robot.Body entry : entries) {
                try {
                    entry.run();
                } catch (ProgramKilled e) {
                    caught.add(e);
                }
            }
            assertThat(robot.kernel.killing()).isTrue();
            robot.kernel.monitorExit(this);
            robot.kernel.monitorExit(lock);
            caught.add(new IllegalStateException("leaving a monitor did not throw"));
        });
        assertThat(caught).hasSize(12);
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
        assertThat(end.timeNanos()).isEqualTo(10 * Robot.MILLI);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void busyLoopsOfManyThreadsEndExactlyAtTheLimit(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(333_333_333), time -> { });
        ProgramEnd end = robot.run(() -> {
            robot.start("a", robot::spin);
            robot.start("b", robot::spin);
            robot.spin();
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
        assertThat(end.timeNanos()).isEqualTo(333_333_333);
        assertThat(robot.kernel.physicsSteps()).isEqualTo(166);
        assertThat(robot.kernel.nowNanos()).isEqualTo(333_333_333);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void shutdownHooksRunInVirtualTimeBeforeTheEnd(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            Thread removed = Robot.thread("removed", () -> robot.note("removed"));
            robot.kernel.addShutdownHook(Robot.thread("hook1", () -> {
                robot.sleepMillis(20);
                robot.note("hook1");
            }));
            robot.kernel.addShutdownHook(removed);
            robot.kernel.addShutdownHook(Robot.thread("hook2", () -> robot.note("hook2")));
            assertThat(robot.kernel.removeShutdownHook(removed)).isTrue();
            assertThat(robot.kernel.removeShutdownHook(removed)).isFalse();
            robot.startDaemon("other", () -> {
                robot.sleepMillis(10);
                robot.note("others go on");
            });
            robot.kernel.exit(4);
        });
        assertThat(robot.log).containsExactly("0 hook2", "10 others go on", "20 hook1");
        assertThat(end.status()).isEqualTo(4);
        assertThat(end.timeNanos() / Robot.MILLI).isEqualTo(20);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aHookMayJoinTheMainThreadThatEndedByItself(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            Thread main = robot.kernel.currentThread();
            robot.kernel.addShutdownHook(Robot.thread("hook", () -> {
                robot.kernel.join(main, 0);
                robot.note("joined");
            }));
        });
        assertThat(robot.log).containsExactly("0 joined");
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aHookThatExitsCountsAsEnded(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.addShutdownHook(Robot.thread("hook", () -> robot.kernel.exit(9)));
            robot.kernel.exit(2);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(end.status()).isEqualTo(2);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aSecondExitWaitsForTheFirst(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.addShutdownHook(Robot.thread("hook", () -> robot.sleepMillis(10)));
            robot.start("second", () -> robot.kernel.exit(2));
            robot.kernel.exit(1);
        });
        assertThat(end.status()).isEqualTo(1);
        assertThat(end.timeNanos() / Robot.MILLI).isEqualTo(10);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void hooksAreRefusedTwiceStartedOrTooLate(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread late = Robot.thread("late", () -> { });
            Thread hook = Robot.thread("hook", () -> assertThatThrownBy(() -> robot.kernel.addShutdownHook(late))
                    .isInstanceOf(IllegalStateException.class));
            robot.kernel.addShutdownHook(hook);
            assertThatThrownBy(() -> robot.kernel.addShutdownHook(hook)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> robot.kernel.addShutdownHook(robot.kernel.currentThread()))
                    .isInstanceOf(IllegalArgumentException.class);
        });
        assertThat(robot.kernel.end().kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void haltRunsNoHooks(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.addShutdownHook(Robot.thread("hook", () -> robot.note("hook")));
            robot.kernel.halt(5);
        });
        assertThat(robot.log).isEmpty();
        assertThat(end.status()).isEqualTo(5);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anUncaughtExceptionFailsTheRunWhenTheOtherThreadsHaveEnded(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        List<String> heard = new ArrayList<>();
        robot.kernel.listen(new KernelListener() {
            @Override
            public void uncaught(Thread thread, Throwable failure) {
                robot.kernel.charge(Robot.MILLI);
                heard.add(thread.getName() + " " + failure.getMessage());
            }
        });
        ProgramEnd end = robot.run(() -> {
            robot.start("other", () -> robot.sleepMillis(50));
            throw new IllegalStateException("broken");
        });
        assertThat(heard).containsExactly("main broken");
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.FAILED);
        assertThat(end.failure()).hasMessage("broken");
        assertThat(end.timeNanos() / Robot.MILLI).isEqualTo(51);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void anUncaughtExceptionBeforeTheTimeLimitIsAFailure(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withLimitNanos(Robot.MILLI));
        ProgramEnd end = robot.run(() -> {
            robot.start("other", robot::spin);
            throw new IllegalStateException("broken");
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.FAILED);
        assertThat(end.timeNanos()).isEqualTo(Robot.MILLI);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void handlersOfTheProgramTakeExceptions(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.setDefaultUncaughtExceptionHandler((thread, failure) -> {
                robot.note("default: " + thread.getName());
                throw new IllegalStateException("ignored, as a JVM does");
            });
            Thread own = Robot.thread("own", () -> {
                throw new IllegalStateException();
            });
            own.setUncaughtExceptionHandler((thread, failure) -> robot.note("own: " + thread.getName()));
            robot.kernel.start(own);
            robot.start("other", () -> {
                throw new IllegalStateException();
            });
            robot.sleepMillis(5);
            assertThat(robot.kernel.getDefaultUncaughtExceptionHandler()).isNotNull();
            robot.kernel.setDefaultUncaughtExceptionHandler(null);
        });
        assertThat(robot.log).containsExactly("1 own: own", "1 default: other");
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aHandlerMayExit(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.kernel.setDefaultUncaughtExceptionHandler((thread, failure) -> robot.kernel.exit(6));
            robot.start("other", robot::spin);
            throw new IllegalStateException();
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        assertThat(end.status()).isEqualTo(6);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void theWorldCanFailARun(BackendChoice backend) {
        Robot[] robot = new Robot[1];
        IllegalStateException fell = new IllegalStateException("fell off the table");
        robot[0] = new Robot(Robot.settings(backend), time -> robot[0].kernel.fail(fell));
        ProgramEnd end = robot[0].run(() -> robot[0].spin());
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.FAILED);
        assertThat(end.failure()).isSameAs(fell);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aKernelRunsOnce(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> { });
        assertThatThrownBy(() -> robot.run(() -> { })).isInstanceOf(IllegalStateException.class);
    }
}
