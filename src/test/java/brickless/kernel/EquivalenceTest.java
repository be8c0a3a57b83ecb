package brickless.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class EquivalenceTest {
    private static final String BACKENDS = "brickless.kernel.Backends#available";
    private static final String ROUND_ROBIN = "144c10c910781650 of 346";
    private static final String SEED_7 = "770cfced7b441342 of 652";

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aHundredRunsAreOneAndTheSameOnEveryBackendAndJdk(BackendChoice backend) {
        for (int i = 0; i < 100; i++) {
            assertThat(fingerprint(Robot.settings(backend))).isEqualTo(ROUND_ROBIN);
        }
    }

    @ParameterizedTest
    @MethodSource(BACKENDS)
    void aSeededScheduleIsTheSameOnEveryBackendAndJdk(BackendChoice backend) {
        for (int i = 0; i < 20; i++) {
            assertThat(fingerprint(Robot.settings(backend).withScheduleSeed(7))).isEqualTo(SEED_7);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void randomProgramsAreTheSameOnAllBackends(int seeded) {
        for (int seed = 0; seed < 40; seed++) {
            KernelSettings settings = Robot.settings(BackendChoice.THREADS).withSeed(seed);
            KernelSettings scheduled = seeded == 0 ? settings : settings.withScheduleSeed(seed);
            String first = randomRun(scheduled);
            for (BackendChoice backend : Backends.available()) {
                assertThat(randomRun(scheduled.withBackend(backend))).as("seed %d", seed).isEqualTo(first);
            }
        }
    }

    @Test
    void kernelsOnManyHostThreadsDoNotDisturbEachOther() throws Exception {
        ExecutorService hosts = Executors.newFixedThreadPool(4);
        try {
            List<Callable<String>> runs = IntStream.range(0, 24)
                    .mapToObj(i -> (Callable<String>) () -> fingerprint(Robot.settings(BackendChoice.AUTO))).toList();
            for (Future<String> run : hosts.invokeAll(runs)) {
                assertThat(run.get()).isEqualTo(ROUND_ROBIN);
            }
        } finally {
            hosts.shutdown();
        }
    }

    private static String randomRun(KernelSettings settings) {
        Robot robot = new Robot(settings.withLimitNanos(60_000 * Robot.MILLI), time -> { });
        ScheduleHash hash = ScheduleHash.of(robot.kernel);
        ProgramEnd end = robot.run(() -> RandomProgram.run(robot));
        // Nested locks in random order may deadlock: an end like any other.
        assertThat(end.kind()).as(end.toString()).isIn(ProgramEnd.Kind.EXITED, ProgramEnd.Kind.DEADLOCK);
        return end.kind().text() + end.timeNanos() + robot.log + hash;
    }

    private static String fingerprint(KernelSettings settings) {
        Robot robot = new Robot(settings.withLimitNanos(300 * Robot.MILLI), time -> { });
        ScheduleHash hash = ScheduleHash.of(robot.kernel);
        ProgramEnd end = robot.run(() -> BusyProgram.run(robot, 6, 1_000));
        assertThat(end.kind()).isEqualTo(ProgramEnd.Kind.TIME_LIMIT);
        return hash.toString();
    }
}
