package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.BackendChoice;
import brickless.loading.RobotClassLoader;
import brickless.program.Program;
import brickless.program.ProgramFinder;
import brickless.simulation.ProgramLoaders.Sharing;
import brickless.simulation.kit.Left;
import brickless.trace.TraceListener;
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
import java.util.Set;
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
    /** A thread that is about to end may still hold something. */
    private static final int COLLECTIONS = 20;
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

    private static RunReport run(ExamplePrograms programs, String main, BackendChoice backend)
            throws DescriptionException {
        return run(programs.program(main), ExamplePrograms.settings(ExamplePrograms.worldOf(main)).backend(backend)
                .scheduleSeed(OptionalLong.of(3)).limit(Duration.ofSeconds(SECONDS)).build());
    }

    private static void assertSame(RunReport again, RunReport first) {
        assertThat(again.outcome()).isEqualTo(first.outcome());
        assertThat(again.traceHash()).as(first.text()).isEqualTo(first.traceHash());
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
            return run(program, settings(BackendChoice.AUTO)).outcome().exitStatus().orElseThrow();
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

    @Test
    void aRunThatDidNotComeToItsEndLeavesNoLoader() throws Exception {
        IDLE.clear();
        engine(Program.onClassPath("programs.speed.Bumper"), settings(BackendChoice.AUTO)).stop();
        assertThat(IDLE.size()).isZero();
    }

    @Test
    void aProgramThatCouldNoticeLeavesNoLoader() throws Exception {
        IDLE.clear();
        run(Program.onClassPath("programs.passing.initialisers.EnumConstants"), settings(BackendChoice.AUTO));
        assertThat(IDLE.size()).isZero();
    }

    @ParameterizedTest
    @MethodSource("backends")
    void classesAndNoObjectOfAProgramRemain(BackendChoice backend) throws Exception {
        IDLE.clear();
        Set<Thread> threads = Thread.getAllStackTraces().keySet();
        RunReport report = run(Program.onClassPath("programs.robots.Hoarder"), settings(backend));
        assertThat(report.outcome().kind()).as(report.outcome() + report.text()).isEqualTo("exited");
        assertThat(IDLE.size()).isEqualTo(1);
        List<WeakReference<Object>> left = Left.taken();
        assertThat(left).hasSize(10);
        RetentionTest.assertNoNewThread(threads);
        for (int i = 0; i < COLLECTIONS && left.stream().anyMatch(object -> object.get() != null); i++) {
            System.gc();
        }
        assertThat(left).allMatch(object -> object.get() == null);
    }

    @Test
    void classesGoWithTheIdleLoaders() throws Exception {
        IDLE.clear();
        List<WeakReference<ClassLoader>> loaders = new ArrayList<>();
        run(Program.onClassPath("programs.robots.Hoarder"), settings(BackendChoice.AUTO));
        Left.taken();
        IDLE.forEach(loader -> loaders.add(new WeakReference<>(loader)));
        assertThat(loaders).hasSize(1);
        IDLE.clear();
        System.gc();
        assertThat(loaders.get(0).get()).isNull();
    }

    @Test
    void theOptionForCompleteExceptionsIsFound() {
        String granted = "-XX:-OmitStackTraceInFastThrow";
        String omitted = "-XX:+OmitStackTraceInFastThrow";
        assertThat(CompleteExceptions.areGrantedBy(List.of("-Xss1m", granted))).isTrue();
        assertThat(CompleteExceptions.areGrantedBy(List.of("-Xss1m"))).isFalse();
        assertThat(CompleteExceptions.areGrantedBy(List.of(granted, omitted))).isFalse();
        assertThat(CompleteExceptions.areGrantedBy(List.of(omitted, granted))).isTrue();
    }

    @Test
    void onlySoManyAreKept() {
        IdleLoaders few = new IdleLoaders(2);
        for (int i = 0; i < 5; i++) {
            few.put(RobotClassLoader.ofApplication());
        }
        assertThat(few.size()).isEqualTo(2);
    }

    private static SimulationSettings settings(BackendChoice backend) throws DescriptionException {
        return ExamplePrograms.settings("pen").backend(backend).limit(Duration.ofSeconds(2)).build();
    }

    /** As a run begins where the JVM grants complete exceptions. */
    private static RunReport run(Program program, SimulationSettings settings) {
        RunEngine engine = engine(program, settings);
        engine.advanceTo(Long.MAX_VALUE);
        return engine.report();
    }

    private static RunEngine engine(Program program, SimulationSettings settings) {
        return new RunEngine(settings, program, Optional.empty(), TraceListener.NONE,
                new ProgramLoaders(Sharing.WITH_OTHER_RUNS));
    }
}
