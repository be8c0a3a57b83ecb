package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.BackendChoice;
import brickless.program.ProgramException;
import brickless.world.DescriptionException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Same program, world, robot and seed: same trace. */
class DeterminismTest {
    private static final int SECONDS = 8;
    private static ExamplePrograms programs;
    private static final Map<String, String> HASHES = new TreeMap<>();

    @BeforeAll
    static void runEveryProgramOnce() throws ProgramException, DescriptionException {
        programs = ExamplePrograms.compiled();
        for (String main : ExamplePrograms.MAINS) {
            HASHES.put(main, hash(main, settings(main)));
        }
    }

    @AfterAll
    static void removeClasses() {
        programs.close();
    }

    static List<String> mains() {
        return ExamplePrograms.MAINS;
    }

    private static SimulationSettings.Builder settings(String main) throws DescriptionException {
        return ExamplePrograms.settings(ExamplePrograms.worldOf(main)).limit(Duration.ofSeconds(SECONDS))
                .backend(BackendChoice.THREADS);
    }

    private static String hash(String main, SimulationSettings.Builder settings) {
        return run(main, settings).traceHash();
    }

    private static RunReport run(String main, SimulationSettings.Builder settings) {
        Run run = new Simulation(settings.build()).start(programs.program(main));
        run.toEnd();
        return run.report();
    }

    @ParameterizedTest
    @MethodSource("mains")
    void sameRunTwice(String main) throws DescriptionException {
        assertThat(hash(main, settings(main))).isEqualTo(HASHES.get(main));
    }

    @ParameterizedTest
    @MethodSource("mains")
    void anotherSeedIsAnotherRun(String main) throws DescriptionException {
        assertThat(hash(main, settings(main).seed(2))).isNotEqualTo(HASHES.get(main));
    }

    @ParameterizedTest
    @MethodSource("mains")
    void theOtherBackendIsTheSameRun(String main)
            throws DescriptionException {
        SimulationSettings.Builder settings = settings(main).backend(BackendChoice.CONTINUATIONS);
        if (BackendChoice.continuationsAvailable()) {
            RunReport report = run(main, settings);
            assertThat(report.backend()).isEqualTo("continuation");
            assertThat(report.traceHash()).isEqualTo(HASHES.get(main));
        } else {
            assertThatThrownBy(() -> run(main, settings)).isInstanceOf(SetupException.class)
                    .hasMessageContaining("needs JDK 21");
        }
    }

    @Test
    void heldEveryTenMillisecondsIsTheSameRun() throws DescriptionException {
        String main = "explorer.Explorer";
        Run run = new Simulation(settings(main).build()).start(programs.program(main));
        while (!run.ended()) {
            run.advance(Duration.ofMillis(10));
        }
        assertThat(run.report().traceHash()).isEqualTo(HASHES.get(main));
    }

    @Test
    void aScheduleSeedIsRepeatable() throws DescriptionException {
        String first = scheduled(7).traceHash();
        assertThat(scheduled(7).traceHash()).isEqualTo(first);
        assertThat(scheduled(8).traceHash()).isNotEqualTo(first);
    }

    @Test
    void noScheduleMakesThreadsThatOpenPortsWaitForEachOther() throws DescriptionException {
        for (long seed = 1; seed <= 10; seed++) {
            assertThat(scheduled(seed).outcome().kind()).as("schedule seed %d", seed).isEqualTo("time-limit");
        }
    }

    private static RunReport scheduled(long scheduleSeed) throws DescriptionException {
        String main = "sensorthreads.SensorThreads";
        return run(main, settings(main).backend(BackendChoice.AUTO).limit(Duration.ofSeconds(1))
                .scheduleSeed(OptionalLong.of(scheduleSeed)));
    }

    @Test
    void manyRunsAtTheSameTimeAreTheSameAsOneByOne() throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(8);
        try {
            Map<String, List<Future<String>>> running = new TreeMap<>();
            for (int round = 0; round < 2; round++) {
                for (String main : ExamplePrograms.MAINS) {
                    running.computeIfAbsent(main, m -> new ArrayList<>())
                            .add(pool.submit(() -> hash(main, settings(main))));
                }
            }
            for (Map.Entry<String, List<Future<String>>> each : running.entrySet()) {
                for (Future<String> hash : each.getValue()) {
                    assertThat(hash.get()).as(each.getKey()).isEqualTo(HASHES.get(each.getKey()));
                }
            }
        } finally {
            pool.shutdownNow();
        }
    }
}
