package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import handwritten.HostLoop;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class WatchdogTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    /** Processor time. */
    private static final long PATIENCE = 500 * Robot.MILLI;

    private final Heartbeat heartbeat = new Heartbeat();
    private long busyNanos;
    private boolean waiting;
    private final Watchdog watchdog = new Watchdog(heartbeat, 1_000,
            () -> new HostActivity(busyNanos, waiting), () -> { });

    /** One look after the thread used some processor time. */
    private boolean runawayAfter(long nanos) {
        busyNanos += nanos;
        return watchdog.isRunaway();
    }

    @Test
    void aThreadThatUsesUpThePatienceWithoutABeatIsARunaway() {
        assertThat(runawayAfter(5_000)).as("first look").isFalse();
        assertThat(runawayAfter(400)).isFalse();
        assertThat(runawayAfter(599)).isFalse();
        assertThat(runawayAfter(1)).isTrue();
    }

    @Test
    void oneBeatStartsTheCountAgain() {
        for (int i = 0; i < 100; i++) {
            if (i % 2 == 0) {
                heartbeat.beat();
            }
            assertThat(runawayAfter(999)).isFalse();
        }
    }

    @Test
    void aThreadThatGetsNoProcessorIsNoRunawayForLong() {
        watchdog.isRunaway();
        for (int i = 1; i < Watchdog.LONGEST_SILENCE; i++) {
            assertThat(runawayAfter(1)).isFalse();
        }
        assertThat(runawayAfter(1)).isTrue();
    }

    @Test
    void aThreadThatWaitsTenLooksForSomethingOutsideTheKernelIsARunaway() {
        waiting = true;
        watchdog.isRunaway();
        for (int i = 1; i < Watchdog.LOOKS; i++) {
            assertThat(watchdog.isRunaway()).isFalse();
        }
        assertThat(watchdog.isRunaway()).isTrue();
    }

    @Test
    void aLongPhysicsStepIsNoRunaway() {
        heartbeat.hostBegins();
        for (int i = 0; i < 1_000; i++) {
            assertThat(runawayAfter(1_000)).isFalse();
        }
        heartbeat.hostEnds();
        assertThat(runawayAfter(1_000)).as("first look after it").isFalse();
        assertThat(runawayAfter(1_000)).isTrue();
    }

    @Test
    void aHostThreadThatWaitsForItsTurnIsNotWaitingForSomethingElse() throws InterruptedException {
        Turn[] turn = new Turn[1];
        Thread thread = new Thread(() -> {
            turn[0].await();
            turn[0].await();
        });
        turn[0] = new Turn(thread);
        turn[0].give();
        while (thread.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
        assertThat(HostActivity.of(thread).waiting()).isFalse();
        turn[0].give();
        thread.join();
    }

    @Test
    void aHostThreadThatWaitsForALockIsWaiting() throws InterruptedException {
        CountDownLatch never = new CountDownLatch(1);
        Thread thread = new Thread(() -> {
            try {
                never.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        thread.start();
        while (thread.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
        assertThat(HostActivity.of(thread).waiting()).isTrue();
        never.countDown();
        thread.join();
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aLoopThatNeverEntersTheKernelEndsAsRunaway(BackendChoice backend) {
        Robot robot = new Robot(Robot.settings(backend).withWatchdogNanos(PATIENCE), time -> { });
        CountDownLatch unwound = new CountDownLatch(1);
        HostLoop program = new HostLoop();
        ProgramEnd end = robot.run(() -> {
            robot.start("waiting", () -> {
                try {
                    robot.kernel.park(0);
                } finally {
                    unwound.countDown();
                }
            });
            robot.sleepMillis(3);
            program.loop();
        });
        program.stop();
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.RUNAWAY);
        assertThat(end.timeNanos()).isEqualTo(3 * Robot.MILLI + Costs.THREAD_START_NANOS);
        assertThat(end.dump()).startsWith("runaway at 3.500 ms\n\"main\" RUNNABLE at HostLoop.java:")
                .contains("\"waiting\" WAITING");
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aRunawayTakesItsEnsembleAlong(BackendChoice backend) {
        Robot good = new Robot(Robot.settings(backend).withName("good").withWatchdogNanos(PATIENCE));
        Robot bad = new Robot(Robot.settings(backend).withName("bad"));
        HostLoop program = new HostLoop();
        good.kernel.main(Robot.thread("main", () -> { }), Robot.runnable(() -> good.sleepMillis(100)));
        bad.kernel.main(Robot.thread("main", () -> { }), program::loop);
        List<ProgramEnd> ends = new Ensemble(List.of(good.kernel, bad.kernel), time -> { }).run();
        program.stop();
        assertThat(ends).extracting(ProgramEnd::kind).containsOnly(ProgramEnd.Kind.RUNAWAY);
        assertThat(ends.get(0).dump()).isEqualTo("ended because bad is a runaway\n");
        assertThat(ends.get(1).dump()).contains("HostLoop.java");
    }
}
