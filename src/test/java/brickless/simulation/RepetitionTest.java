package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.bench.BusyHost;
import brickless.kernel.BackendChoice;
import brickless.program.ProgramException;
import brickless.world.DescriptionException;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Many threads, again and again, on a host whose processors are all busy with something else: one run.
 * {@code bench.Repetitions} does more.
 */
class RepetitionTest {
    private static final int REPETITIONS = 10;
    private static final Duration LENGTH = Duration.ofSeconds(20);
    private static ExamplePrograms programs;

    @BeforeAll
    static void compile() throws ProgramException {
        programs = ExamplePrograms.compiled();
    }

    @AfterAll
    static void removeClasses() {
        programs.close();
    }

    static List<BackendChoice> backends() {
        return RetentionTest.backends();
    }

    private static RunReport run(String main, BackendChoice backend) throws DescriptionException {
        Run run = new Simulation(ExamplePrograms.settings("pen").backend(backend).limit(LENGTH).build())
                .start(programs.program(main));
        run.toEnd();
        return run.report();
    }

    @ParameterizedTest
    @MethodSource("backends")
    void aRunIsTheSameEveryTimeWhileTheHostIsBusy(BackendChoice backend) throws Exception {
        RunReport first = run("sensorthreads.SensorThreads", BackendChoice.THREADS);
        assertThat(first.contextSwitches()).as("there is something to go wrong").isGreaterThan(1_000);
        try (BusyHost busy = new BusyHost()) {
            for (int i = 0; i < REPETITIONS; i++) {
                assertThat(run("sensorthreads.SensorThreads", backend).traceHash()).as("repetition %d", i)
                        .isEqualTo(first.traceHash());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("backends")
    void aProgramOfOneThreadNeedsNoSwitches(BackendChoice backend) throws Exception {
        assertThat(run("square.Square", backend).contextSwitches()).as("only the threads of leJOS itself start and end")
                .isLessThan(10);
    }
}
