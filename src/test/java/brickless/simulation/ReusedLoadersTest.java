package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.BackendChoice;
import brickless.program.Program;
import brickless.program.ProgramFinder;
import brickless.world.DescriptionException;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Runs in classes of earlier runs of the JVM are the same as the first. */
class ReusedLoadersTest {
    private static final int SECONDS = 8;
    private static final IdleLoaders IDLE = IdleLoaders.ofTheJvm();

    static List<BackendChoice> backends() {
        return RetentionTest.backends();
    }

    @ParameterizedTest
    @MethodSource("backends")
    void theExamplesRunAgainInAnyOrderAsInNewClasses(BackendChoice backend) throws Exception {
        Map<String, RunReport> first = new HashMap<>();
        List<String> mains = new ArrayList<>(ExamplePrograms.MAINS);
        try (ExamplePrograms programs = ExamplePrograms.compiled()) {
            for (String main : mains) {
                IDLE.clear();
                first.put(main, run(programs, main, backend));
            }
        }
        long before = IDLE.reused();
        for (int round = 0; round < 2; round++) {
            Collections.reverse(mains);
            try (ExamplePrograms compiledAnew = ExamplePrograms.compiled()) {
                for (String main : mains) {
                    assertSame(run(compiledAnew, main, backend), first.get(main));
                }
            }
        }
        assertThat(IDLE.reused() - before).as("runs in used classes").isGreaterThan(mains.size());
    }

    private static RunReport run(ExamplePrograms programs, String main, BackendChoice backend) throws DescriptionException {
        Run run = new Simulation(ExamplePrograms.settings(ExamplePrograms.worldOf(main)).backend(backend)
                .scheduleSeed(OptionalLong.of(3)).limit(Duration.ofSeconds(SECONDS)).build()).start(programs.program(main));
        run.toEnd();
        return run.report();
    }

    private static void assertSame(RunReport again, RunReport first) {
        assertThat(again.outcome()).isEqualTo(first.outcome());
        assertThat(again.traceHash()).as(first.text()).isEqualTo(first.traceHash());
        assertThat(again.text()).isEqualTo(first.text());
    }

    @Test
    void aProgramThatHasChangedDoesNotGetTheOldClasses(@TempDir Path folder) throws Exception {
        String source = "public class Says { public static void main(String[] a) { System.exit(%d); } }";
        assertThat(exitStatus(folder, String.format(source, 3))).isEqualTo(3);
        long before = IDLE.reused();
        assertThat(exitStatus(folder, String.format(source, 4))).isEqualTo(4);
        assertThat(IDLE.reused()).isEqualTo(before);
        assertThat(exitStatus(folder, String.format(source, 3))).isEqualTo(3);
        assertThat(IDLE.reused()).isEqualTo(before + 1);
    }

    @Test
    void whatOnlyOneOfTwoClassPathsHasIsNoticed(@TempDir Path folder) throws Exception {
        String says = "public class Says { public static void main(String[] a) { System.exit(Other.status()); } }";
        String other = "class Other { static int status() { return %d; } }";
        assertThat(exitStatus(folder, says, String.format(other, 5))).isEqualTo(5);
        assertThat(exitStatus(folder, says, String.format(other, 6))).isEqualTo(6);
        assertThat(exitStatus(folder, says, String.format(other, 5))).isEqualTo(5);
    }

    private static int exitStatus(Path folder, String... sources) throws Exception {
        Path file = folder.resolve("Says.java");
        Files.writeString(file, String.join("\n", sources));
        try (Program program = new ProgramFinder(folder, List.of(), Optional.empty()).find("Says.java")) {
            Run run = new Simulation(ExamplePrograms.settings("pen").build()).start(program);
            run.toEnd();
            return run.outcome().exitStatus().orElseThrow();
        }
    }

    @Test
    void parallelRunsHaveLoadersOfTheirOwn() throws Exception {
        try (ExamplePrograms programs = ExamplePrograms.compiled()) {
            String hash = run(programs, "square.Square", BackendChoice.AUTO).traceHash();
            ExecutorService jobs = Executors.newFixedThreadPool(4);
            List<Future<RunReport>> reports = new ArrayList<>();
            for (int i = 0; i < 12; i++) {
                reports.add(jobs.submit(() -> run(programs, "square.Square", BackendChoice.AUTO)));
            }
            for (Future<RunReport> report : reports) {
                assertThat(report.get().traceHash()).isEqualTo(hash);
            }
            jobs.shutdown();
        }
    }

    @ParameterizedTest
    @MethodSource("backends")
    void aClosedRunAndARunawayLeaveNoLoader(BackendChoice backend) throws Exception {
        IDLE.clear();
        try (Run run = new Simulation(ExamplePrograms.settings("pen").backend(backend).build())
                .start(Program.onClassPath("programs.speed.Bumper"))) {
            assertThat(run.ended()).isFalse();
        }
        assertThat(IDLE.size()).isZero();
    }

    @Test
    void aProgramThatCouldNoticeLeavesNoLoader() {
        IDLE.clear();
        runOnClassPath("programs.passing.initialisers.EnumConstants");
        assertThat(IDLE.size()).isZero();
    }

    @Test
    void noObjectOfAProgramRemainsWithItsClasses() throws Exception {
        IDLE.clear();
        List<WeakReference<ClassLoader>> loaders = new ArrayList<>();
        runOnClassPath("programs.speed.Bumper");
        assertThat(IDLE.size()).isEqualTo(1);
        IDLE.clear();
        assertThat(loaders).isEmpty();
    }

    @Test
    void onlySoManyAreKept() throws Exception {
        IdleLoaders few = new IdleLoaders(2);
        for (int i = 0; i < 5; i++) {
            few.put(brickless.loading.RobotClassLoader.ofApplication());
        }
        assertThat(few.size()).isEqualTo(2);
    }

    private static void runOnClassPath(String program) {
        Run run = new Simulation(settings()).start(Program.onClassPath(program));
        run.toEnd();
    }

    private static SimulationSettings settings() {
        try {
            return ExamplePrograms.settings("pen").limit(Duration.ofSeconds(2)).build();
        } catch (DescriptionException broken) {
            throw new IllegalStateException(broken);
        }
    }
}
