package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.BackendChoice;
import brickless.kernel.KernelSettings;
import brickless.kernel.ProgramEnd;
import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Whole programs on a kernel: each does one thing, its comment says what must happen, and it happens the same way every
 * time.
 */
class ProgramsTest {
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    @TestFactory
    Stream<DynamicTest> programsEndAsTheirCommentsSay() throws IOException {
        return FixtureProgram.all().stream()
                .map(program -> DynamicTest.dynamicTest(program.mainClass(), () -> check(program)));
    }

    private static void check(FixtureProgram program) {
        ProgramRun first = run(program, settings(program).withBackend(BackendChoice.THREADS));
        assertThat(describe(first.end())).as(first.output() + first.end().dump()).isEqualTo(program.expected());
        if (!program.prints().isEmpty()) {
            assertThat(first.output().lines().collect(Collectors.toList())).isEqualTo(program.prints());
        }
        for (String part : program.contains()) {
            assertThat(first.output() + first.end().dump()).contains(part);
        }
        ProgramRun again = run(program, settings(program).withBackend(BackendChoice.AUTO));
        assertThat(again.output()).isEqualTo(first.output());
        if (!program.outside()) {
            assertThat(again.traceHash()).isEqualTo(first.traceHash());
        }
        if (program.explore() != null) {
            explore(program);
        }
        for (int seed = 0; seed < program.schedules(); seed++) {
            checkSchedule(program, seed, first);
        }
    }

    /** Another order of the threads, on both back-ends, comes to the same. */
    private static void checkSchedule(FixtureProgram program, int seed, ProgramRun first) {
        KernelSettings settings = settings(program).withScheduleSeed(seed);
        ProgramRun threads = run(program, settings.withBackend(BackendChoice.THREADS));
        assertThat(describe(threads.end())).as("seed %d: %s%s", seed, threads.output(), threads.end().dump())
                .isEqualTo(program.expected());
        assertThat(threads.output()).as("seed %d", seed).isEqualTo(first.output());
        ProgramRun best = run(program, settings.withBackend(BackendChoice.AUTO));
        assertThat(best.traceHash()).as("seed %d on the other back-end", seed).isEqualTo(threads.traceHash());
    }

    private static void explore(FixtureProgram program) {
        List<String> words = List.of(program.explore().split(" ", 2));
        for (int seed = 0; seed < Integer.parseInt(words.get(0)); seed++) {
            ProgramRun run = run(program, settings(program).withScheduleSeed(seed));
            if (describe(run.end()).equals(words.get(1))) {
                ProgramRun again = run(program, settings(program).withScheduleSeed(seed));
                assertThat(again.traceHash()).as("seed %d again", seed).isEqualTo(run.traceHash());
                return;
            }
        }
        throw new AssertionError("none of " + words.get(0) + " schedules ended as " + words.get(1));
    }

    private static KernelSettings settings(FixtureProgram program) {
        return KernelSettings.defaults().withLimitNanos(program.limitSeconds() * NANOS_PER_SECOND);
    }

    private static ProgramRun run(FixtureProgram program, KernelSettings settings) {
        return ProgramRun.of(program.mainClass(), settings, program.input());
    }

    private static String describe(ProgramEnd end) {
        switch (end.kind()) {
            case EXITED:
                return "exited " + end.status();
            case FAILED:
                return "failed " + end.failure().getClass().getName();
            default:
                return end.kind().text();
        }
    }
}
