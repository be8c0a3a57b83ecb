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
    /** Host time; long enough that a loaded machine does not look like a runaway before the program reaches its loop. */
    private static final long PATIENCE = 500 * Robot.MILLI;

    private final Heartbeat heartbeat = new Heartbeat();
    private final Watchdog watchdog = new Watchdog(heartbeat, () -> { });

    @Test
    void tenLooksWithoutABeatAreARunaway() {
        watchdog.isRunaway(heartbeat.read());
        for (int i = 1; i < Watchdog.LOOKS; i++) {
            assertThat(watchdog.isRunaway(heartbeat.read())).isFalse();
        }
        assertThat(watchdog.isRunaway(heartbeat.read())).isTrue();
    }

    @Test
    void oneBeatStartsTheCountAgain() {
        for (int i = 0; i < 100; i++) {
            if (i % (Watchdog.LOOKS - 1) == 0) {
                heartbeat.beat();
            }
            assertThat(watchdog.isRunaway(heartbeat.read())).isFalse();
        }
    }

    @Test
    void aLongPhysicsStepIsNoRunaway() {
        heartbeat.hostBegins();
        for (int i = 0; i < 100; i++) {
            assertThat(watchdog.isRunaway(heartbeat.read())).isFalse();
        }
        heartbeat.hostEnds();
        for (int i = 0; i < Watchdog.LOOKS; i++) {
            assertThat(watchdog.isRunaway(heartbeat.read())).isFalse();
        }
        assertThat(watchdog.isRunaway(heartbeat.read())).isTrue();
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
