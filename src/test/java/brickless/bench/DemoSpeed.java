package brickless.bench;

import brickless.kernel.BackendChoice;
import brickless.program.Program;
import brickless.program.ProgramFinder;
import brickless.simulation.Library;
import brickless.simulation.RunReport;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * How fast whole programs run, with physics: {@code DemoSpeed PROGRAM SECONDS REPETITIONS auto|threads|continuations}. The first line of
 * the output includes the warm-up of the JVM.
 */
public final class DemoSpeed {
    private DemoSpeed() {}

    /** Runs the benchmark. */
    public static void main(String[] args) throws Exception {
        Library library = new Library(Path.of(""));
        SimulationSettings settings = SimulationSettings.builder(library.world("pen")).limit(Duration.ofSeconds(Integer.parseInt(args[1])))
                .backend(BackendChoice.valueOf(args[3].toUpperCase(Locale.ROOT))).build();
        try (Program program = new ProgramFinder(Path.of("").toAbsolutePath(), List.of(), Optional.empty()).find(args[0])) {
            for (int i = 0; i < Integer.parseInt(args[2]); i++) {
                long cpu = cpuNanos();
                Run run = new Simulation(settings).start(program);
                run.toEnd();
                print(run.report(), (cpuNanos() - cpu) / 1e9);
            }
        }
    }

    private static void print(RunReport report, double cpuSeconds) {
        System.out.printf(Locale.ROOT, "%5.0f x real time, %.2f ms wall and %.2f ms CPU per simulated second, %.0f switches per simulated second, %s%n",
                report.realTimeFactor(), report.wallSeconds() / report.simulatedSeconds() * 1e3, cpuSeconds / report.simulatedSeconds() * 1e3,
                report.contextSwitches() / report.simulatedSeconds(), report.backend());
    }

    private static long cpuNanos() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime();
    }
}
