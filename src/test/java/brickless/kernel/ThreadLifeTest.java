package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ThreadLifeTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void joinReturnsWhenTheThreadEnds(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread worker = robot.start("worker", () -> robot.sleepMillis(30));
            robot.kernel.join(worker, 10 * Robot.MILLI);
            robot.note("still " + robot.kernel.isAlive(worker));
            robot.kernel.join(worker, 0);
            robot.note("still " + robot.kernel.isAlive(worker));
            robot.kernel.join(worker, 0);
        });
        assertThat(robot.log).containsExactly("10 still true", "30 still false");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void joiningAThreadThatWasNotStartedReturnsAtOnce(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> robot.kernel.join(Robot.thread("never", () -> { }), 0));
        assertThat(end.timeNanos()).isZero();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void startingDoesNotSwitch(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.start("other", () -> robot.note("other"));
            robot.note("main");
        });
        assertThat(robot.log).containsExactly("0 main", "0 other");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aThreadStartsOnce(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread thread = robot.start("once", () -> { });
            assertThatThrownBy(() -> robot.kernel.start(thread)).isInstanceOf(IllegalThreadStateException.class);
            robot.kernel.join(thread, 0);
            assertThatThrownBy(() -> robot.kernel.start(thread)).isInstanceOf(IllegalThreadStateException.class);
        });
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void statesAreThoseOfTheJdk(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        Object lock = new Object();
        robot.run(() -> {
            Thread fresh = Robot.thread("fresh", () -> { });
            Thread sleeper = robot.startDaemon("sleeper", () -> robot.sleepMillis(1_000));
            Thread waiter = robot.startDaemon("waiter",
                    () -> robot.locked(lock, () -> robot.kernel.monitorWait(lock, 0)));
            Thread timed = robot.startDaemon("timed",
                    () -> robot.locked(lock, () -> robot.kernel.monitorWait(lock, 1_000 * Robot.MILLI)));
            Thread parked = robot.startDaemon("parked", () -> robot.kernel.park(0));
            Thread joiner = robot.startDaemon("joiner", () -> robot.kernel.join(sleeper, 0));
            Thread ready = robot.startDaemon("ready", robot::spin);
            Thread done = robot.start("done", () -> { });
            robot.sleepMillis(50);
            assertThat(robot.kernel.state(fresh)).isEqualTo(Thread.State.NEW);
            assertThat(robot.kernel.state(sleeper)).isEqualTo(Thread.State.TIMED_WAITING);
            assertThat(robot.kernel.state(waiter)).isEqualTo(Thread.State.WAITING);
            assertThat(robot.kernel.state(timed)).isEqualTo(Thread.State.TIMED_WAITING);
            assertThat(robot.kernel.state(parked)).isEqualTo(Thread.State.WAITING);
            assertThat(robot.kernel.state(joiner)).isEqualTo(Thread.State.WAITING);
            assertThat(robot.kernel.state(ready)).isEqualTo(Thread.State.RUNNABLE);
            assertThat(robot.kernel.state(done)).isEqualTo(Thread.State.TERMINATED);
            assertThat(robot.kernel.state(robot.kernel.currentThread())).isEqualTo(Thread.State.RUNNABLE);
            assertThat(robot.kernel.threads()).extracting(Thread::getName)
                    .containsExactly("main", "sleeper", "waiter", "timed", "parked", "joiner", "ready");
            robot.note("checked");
        });
        assertThat(robot.log).hasSize(1);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void daemonThreadsDoNotKeepTheProgramAlive(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        ProgramEnd end = robot.run(() -> {
            robot.startDaemon("daemon", robot::spin);
            robot.start("worker", () -> robot.sleepMillis(20));
            robot.sleepMillis(5);
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.EXITED);
        // The worker sleeps from 11 ms, after the daemon's first slice, to 31 ms; each switch waits for the end of a
        // loop turn.
        assertThat(end.timeNanos()).isBetween(31 * Robot.MILLI, 31 * Robot.MILLI + 2 * Costs.BACK_EDGE_NANOS);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void parkReturnsAtOnceAfterAnEarlierUnpark(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            Thread me = robot.kernel.currentThread();
            robot.kernel.unpark(me);
            robot.kernel.unpark(me);
            robot.kernel.park(0);
            robot.note("permit used");
            robot.kernel.park(3 * Robot.MILLI);
            robot.note("timed out");
            robot.start("other", () -> {
                robot.sleepMillis(10);
                robot.kernel.unpark(me);
            });
            robot.kernel.park(0);
            robot.note("unparked");
            robot.kernel.park(Robot.MILLI);
            robot.note("no permit was left");
        });
        assertThat(robot.log).containsExactly("0 permit used", "3 timed out", "13 unparked", "14 no permit was left");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void endlessThreadCreationRunsOutOfMemoryLikeAJvm(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withMaximumThreads(20));
        ProgramEnd end = robot.run(() -> {
            while (true) {
                robot.start("t", () -> robot.sleepMillis(1_000_000));
            }
        });
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.FAILED);
        assertThat(end.failure()).isInstanceOf(OutOfMemoryError.class);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aPollingThreadThatYieldsPaysMoreAndMoreUntilItMakesProgress(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        long[] times = new long[9];
        robot.run(() -> {
            for (int i = 0; i < 6; i++) {
                robot.kernel.yieldProcessor();
                times[i] = robot.kernel.nowNanos() / 1_000;
            }
            robot.kernel.progress();
            robot.kernel.yieldProcessor();
            times[6] = robot.kernel.nowNanos() / 1_000;
            robot.kernel.yieldProcessor();
            times[7] = robot.kernel.nowNanos() / 1_000;
            robot.sleepMillis(1);
            robot.kernel.yieldProcessor();
            times[8] = robot.kernel.nowNanos() / 1_000;
        });
        assertThat(times).containsExactly(100, 300, 700, 1_500, 2_500, 3_500, 3_600, 3_800, 4_900);
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void yieldLetsTheOthersRunInTurn(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            for (String name : new String[] {"a", "b"}) {
                robot.start(name, () -> {
                    for (int i = 0; i < 3; i++) {
                        robot.log.add(name + i);
                        robot.kernel.yieldProcessor();
                    }
                });
            }
        });
        assertThat(robot.log).containsExactly("a0", "b0", "a1", "b1", "a2", "b2");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void eachThreadHasItsOwnCallDepth(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend));
        robot.run(() -> {
            robot.budget.depth(7);
            robot.start("other", () -> {
                robot.log.add("other begins at " + robot.budget.depth());
                robot.budget.depth(3);
                robot.sleepMillis(5);
                robot.log.add("other is back at " + robot.budget.depth());
            });
            robot.sleepMillis(1);
            robot.log.add("main is back at " + robot.budget.depth());
        });
        assertThat(robot.log).containsExactly("other begins at 0", "main is back at 7", "other is back at 3");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void numbersOfTheProgramDoNotComeFromTheHost(BackendChoice backend) {
        for (int run = 0; run < 2; run++) {
            Robot robot = new Robot(Robot.settings(backend).withSeed(5).withEpochMillis(1_000));
            robot.run(() -> {
                robot.log.add("" + robot.kernel.nextThreadNumber() + robot.kernel.nextThreadNumber());
                robot.log.add("" + robot.kernel.nextThreadId() + robot.kernel.nextThreadId());
                robot.log.add("" + new java.util.Random(Seeds.spread(5)).longs(2).sum()
                        + "=" + (robot.kernel.nextRandomLong() + robot.kernel.nextRandomLong()));
                // 4096 · 1103515245 + 12345 modulo 2^31
                robot.log.add("" + robot.kernel.nextIdentityHash());
                robot.sleepMillis(4);
                robot.log.add(robot.kernel.currentTimeMillis() + " " + robot.kernel.nanoTime());
            });
            long sum = new java.util.Random(Seeds.spread(5)).longs(2).sum();
            assertThat(robot.log).containsExactly("01", "12", sum + "=" + sum, "1692860473", "1004 4004000");
        }
    }
}
