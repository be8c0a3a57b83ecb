package brickless.bench;

import brickless.kernel.BackendChoice;
import brickless.program.Program;
import brickless.program.ProgramFinder;
import brickless.simulation.Library;
import brickless.simulation.Run;
import brickless.simulation.RunReport;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Runs a program many times while all processors are busy with other work, and counts how many different runs there
 * were (it must be one): {@code Repetitions PROGRAM REPETITIONS SECONDS threads|continuations}.
 */
public final class Repetitions {
    private Repetitions() {}

    /** Runs the check. */
    public static void main(String[] args) throws Exception {
        SimulationSettings settings = SimulationSettings.builder(new Library(Path.of("")).world("pen"))
                .limit(Duration.ofSeconds(Integer.parseInt(args[2])))
                .backend(BackendChoice.valueOf(args[3].toUpperCase(Locale.ROOT))).build();
        TreeMap<String, Integer> hashes = new TreeMap<>();
        double wallSeconds = 0;
        try (Program program = new ProgramFinder(Path.of("").toAbsolutePath(), List.of(), Optional.empty())
                .find(args[0]);
                BusyHost busy = new BusyHost()) {
            for (int i = 0; i < Integer.parseInt(args[1]); i++) {
                Run run = new Simulation(settings).start(program);
                run.toEnd();
                RunReport report = run.report();
                hashes.merge(report.outcome().kind() + " " + report.traceHash() + " " + report.contextSwitches()
                        + " switches", 1, Integer::sum);
                wallSeconds += report.wallSeconds();
            }
        }
        System.out.printf(Locale.ROOT, "JDK %s, %s: %s, %.1f s of wall time%n", Runtime.version(), args[3],
                hashes, wallSeconds);
        if (hashes.size() != 1) {
            System.exit(1);
        }
    }
}
