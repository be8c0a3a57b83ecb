package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.BackendChoice;
import brickless.kernel.KernelSettings;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** A program behaves in classes that earlier programs have used, itself among them, as it does in new ones. */
class ReusedClassesTest {
    private static final int REPETITIONS = 3;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    private RobotClassLoader loader = RobotClassLoader.ofApplication().forSeveralRobots();
    private int reused;

    /** Those are abandoned: their classes are not used again. */
    private static boolean endsOnTheHost(FixtureProgram program) {
        return program.expected().equals("runaway") || program.outside();
    }

    @TestFactory
    Stream<DynamicTest> everyProgramDoesTheSameAgainAndAfterOthers() throws IOException {
        return tests("", BackendChoice.AUTO, false);
    }

    @TestFactory
    Stream<DynamicTest> inOtherSchedulesToo() throws IOException {
        return tests("", BackendChoice.AUTO, true);
    }

    @TestFactory
    Stream<DynamicTest> onThreadsToo() throws IOException {
        return Stream.of(".statics.", ".initialisers.", "failing.", ".threads.")
                .flatMap(part -> tests(part, BackendChoice.THREADS, true));
    }

    @AfterEach
    void mostRunsWereInUsedClasses() {
        assertThat(reused).isGreaterThan(30);
    }

    private Stream<DynamicTest> tests(String part, BackendChoice backend, boolean otherSchedule) {
        try {
            return FixtureProgram.all().stream()
                    .filter(program -> !endsOnTheHost(program) && program.mainClass().contains(part))
                    .map(program -> DynamicTest.dynamicTest(program.mainClass(),
                            () -> check(program, backend, otherSchedule)));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private void check(FixtureProgram program, BackendChoice backend, boolean otherSchedule) {
        KernelSettings plain = KernelSettings.defaults().withLimitNanos(program.limitSeconds() * NANOS_PER_SECOND)
                .withBackend(backend);
        KernelSettings settings = otherSchedule ? plain.withScheduleSeed(5) : plain;
        ProgramRun first = ProgramRun.of(program.mainClass(), settings, program.input());
        for (int i = 0; i < REPETITIONS; i++) {
            ProgramRun again = ProgramRun.run(loader, program.mainClass(), settings, program.input());
            assertThat(again.output()).as("run %d", i).isEqualTo(first.output());
            assertThat(again.end().kind()).as("run %d", i).isEqualTo(first.end().kind());
            assertThat(again.end().dump()).as("run %d", i).isEqualTo(first.end().dump());
            assertThat(again.traceHash()).as("run %d", i).isEqualTo(first.traceHash());
            leaveToTheNext();
        }
    }

    private void leaveToTheNext() {
        if (loader.obstacleToReuse().isPresent()) {
            loader = RobotClassLoader.ofApplication().forSeveralRobots();
        } else {
            loader.forget();
            reused++;
        }
    }
}
