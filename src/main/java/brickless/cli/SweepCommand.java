package brickless.cli;

import brickless.program.Program;
import brickless.simulation.Run;
import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;

/**
 * {@code brickless sweep}: one program in many worlds with many seeds, one JSON line per run, in order, whatever the
 * number of jobs.
 */
@Command(name = "sweep", description = "Runs a program in many worlds with many seeds; one JSON line per run.",
        mixinStandardHelpOptions = true)
final class SweepCommand implements Callable<Integer> {
    @Mixin
    private RunOptions options;

    @Option(names = "--worlds", paramLabel = "GLOB",
            description = "Worlds: a file, a pattern such as 'sim/worlds/*.svg', or a bundled name; can be given again "
                    + "(default: that of --world).")
    private List<String> worlds = List.of();

    @Option(names = "--seeds", paramLabel = "RANGE",
            description = "Seeds: 1..100, or 3,7,11..15 (default: that of --seed).")
    private String seeds;

    @Option(names = "--jobs", paramLabel = "N", description = "Runs at the same time (default: one per processor).")
    private int jobs = Runtime.getRuntime().availableProcessors();

    @Option(names = "--out", paramLabel = "FILE",
            description = "File for the lines; an unfinished one is continued (default: standard output).")
    private Path out;

    @ParentCommand
    private Main main;

    @Override
    public Integer call() throws InterruptedException, IOException {
        if (jobs < 1) {
            throw new UsageException("--jobs must be at least 1");
        }
        List<SweepRun> plan = SweepPlan.of(worlds.isEmpty() ? List.of(options.world) : worlds,
                seeds == null ? String.valueOf(options.seed) : seeds);
        Map<String, SimulationSettings> settings = new LinkedHashMap<>();
        plan.forEach(run -> settings.computeIfAbsent(run.world(), options::settings));
        try (Program program = options.findProgram(); SweepLines lines = out == null
                ? SweepLines.to(main.out()) : SweepLines.in(out)) {
            lines.continueFrom(plan, settings, last -> line(program, settings, last));
            return run(program, plan, settings, lines);
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        }
    }

    private int run(Program program, List<SweepRun> plan, Map<String, SimulationSettings> settings, SweepLines lines)
            throws InterruptedException, IOException {
        SweepProgress progress = new SweepProgress(main.err(), plan.size(), lines.count(), lines.failed());
        ExecutorService pool = Executors.newFixedThreadPool(jobs);
        try {
            List<Future<String>> results = new ArrayList<>();
            plan.subList(lines.count(), plan.size())
                    .forEach(run -> results.add(pool.submit(() -> line(program, settings, run))));
            for (Future<String> result : results) {
                lines.add(result.get());
                progress.done(lines.count(), lines.failed());
            }
        } catch (ExecutionException e) {
            throw unwrapped(e.getCause());
        } finally {
            pool.shutdownNow();
            progress.end();
        }
        return lines.failed() > 0 ? 1 : 0;
    }

    private static String line(Program program, Map<String, SimulationSettings> settings, SweepRun sweepRun) {
        SimulationSettings own = settings.get(sweepRun.world()).toBuilder().seed(sweepRun.seed()).build();
        try (Run run = new Simulation(own).start(program)) {
            run.toEnd();
            return run.report().portableJson();
        }
    }

    private static RuntimeException unwrapped(Throwable cause) {
        return cause instanceof RuntimeException exception ? exception : new IllegalStateException(cause);
    }
}
