package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.kernel.BackendChoice;
import brickless.world.DescriptionException;
import java.lang.management.ManagementFactory;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import programs.passing.threads.StartAndJoin;

/** What is left when a run is over: nothing. */
class RetentionTest {
    private static final String THREADS = "sensorthreads.SensorThreads";
    /** The full size, 200, is asked for by a property; it takes some minutes. */
    private static final int RUNS = Integer.getInteger("brickless.leakRuns", 40);
    private static final int WARM_UP = RUNS / 4;
    private static final int COLLECTIONS = 6;
    private static final long PATIENCE_MILLIS = 30_000;
    @AutoClose private static final ExamplePrograms programs = ExamplePrograms.compiled();

    static List<BackendChoice> backends() {
        return BackendChoice.continuationsAvailable() ? List.of(BackendChoice.THREADS, BackendChoice.CONTINUATIONS)
                : List.of(BackendChoice.THREADS);
    }

    private static Run run(BackendChoice backend, int millis) throws DescriptionException {
        return new Simulation(ExamplePrograms.settings("pen").backend(backend).limit(Duration.ofMillis(millis)).build())
                .start(programs.program(THREADS));
    }

    @ParameterizedTest
    @MethodSource("backends")
    void noThreadRemains(BackendChoice backend) throws Exception {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        Run run = run(backend, 500);
        run.toEnd();
        assertNoNewThread(before);
    }

    static void assertNoNewThread(Set<Thread> before) throws InterruptedException {
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (!before.contains(thread) && thread.getName().startsWith("brickless")) {
                thread.join(PATIENCE_MILLIS);
                assertThat(thread.isAlive()).as(thread.getName()).isFalse();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("backends")
    void aRunThatIsClosedBeforeItsEndIsOver(BackendChoice backend) throws Exception {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        try (Run run = run(backend, 60_000)) {
            run.advance(Duration.ofMillis(200));
        }
        assertNoNewThread(before);
    }

    @ParameterizedTest
    @MethodSource("backends")
    void anInterruptOfTheThreadThatDrivesTheRunEndsIt(BackendChoice backend) throws Exception {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        Run run = run(backend, 3_600_000);
        Thread.currentThread().interrupt();
        assertThatThrownBy(run::toEnd).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).as("interrupt flag kept").isTrue();
        assertThat(run.ended()).isTrue();
        assertThat(run.time()).isLessThan(Duration.ofHours(1));
        assertNoNewThread(before);
    }

    @ParameterizedTest
    @MethodSource("backends")
    void classesAreCollectedAndTheHeapDoesNotGrow(BackendChoice backend) throws Exception {
        Set<Thread> threads = Thread.getAllStackTraces().keySet();
        List<WeakReference<ClassLoader>> loaders = new ArrayList<>();
        for (int i = 0; i < WARM_UP; i++) {
            runAndForget(backend, loaders);
        }
        assertNoNewThread(threads);
        long before = usedHeap();
        for (int i = WARM_UP; i < RUNS; i++) {
            runAndForget(backend, loaders);
        }
        assertNoNewThread(threads);
        long after = usedHeap();
        assertThat(loaders.stream().filter(loader -> loader.get() != null))
                .as("loaders that are still there").isEmpty();
        assertThat(after).as("bytes of heap after %d runs, %d after %d", RUNS, before, WARM_UP)
                .isLessThan(before + before / 20);
    }

    private static void runAndForget(BackendChoice backend, List<WeakReference<ClassLoader>> loaders)
            throws DescriptionException {
        Run run = new Simulation(ExamplePrograms.settings("pen").backend(backend).limit(Duration.ofMillis(300)).build())
                .start(StartAndJoin.class, robot -> {
                    loaders.add(new WeakReference<>(robot));
                    robot.loadClass("lejos.hardware.motor.Motor").getField("B").get(null);
                    robot.loadClass(StartAndJoin.class.getName()).getMethod("main", String[].class)
                            .invoke(null, (Object) new String[0]);
                });
        run.toEnd();
        assertThat(run.outcome().kind()).isEqualTo("exited");
    }

    /** After as many collections as it takes: cleaners and compilations in progress let go between two of them. */
    private static long usedHeap() {
        long used = Long.MAX_VALUE;
        for (int i = 0; i < COLLECTIONS; i++) {
            System.gc();
            used = Math.min(used, ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
        }
        return used;
    }

    @Test
    void compiledClassesAreRemovedHoweverTheRunEnds(@TempDir Path folder) throws Exception {
        assertLeavesNothing(folder, "public class Fine { public static void main(String[] a) { } }", "Fine", 0);
        assertLeavesNothing(folder, "public class Fails { public static void main(String[] a) { throw new "
                + "RuntimeException(); } }", "Fails", 1);
        assertLeavesNothing(folder, "public class Wrong { int i = \"no number\"; }", "Wrong", 2);
        assertLeavesNothing(folder, "public class Empty { }", "Empty", 2);
    }

    /** In a JVM of its own, whose temporary directory nobody else uses. */
    private static void assertLeavesNothing(Path folder, String source, String name, int status) throws Exception {
        Path file = Files.writeString(folder.resolve(name + ".java"), source);
        Path temporary = Files.createDirectory(folder.resolve("temporary-" + name));
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:-UsePerfData", "-Djava.io.tmpdir=" + temporary, "-cp", System.getProperty("java.class.path"),
                "brickless.cli.Main", "run", file.toString(), "--out", folder.resolve("out").toString())
                .redirectErrorStream(true).redirectOutput(folder.resolve("log.txt").toFile()).start();
        assertThat(process.waitFor(PATIENCE_MILLIS * 4, TimeUnit.MILLISECONDS)).isTrue();
        assertThat(process.exitValue()).as(Files.readString(folder.resolve("log.txt"))).isEqualTo(status);
        try (Stream<Path> left = Files.list(temporary)) {
            assertThat(left).isEmpty();
        }
    }
}
