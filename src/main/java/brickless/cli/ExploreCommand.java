package brickless.cli;

import brickless.program.Program;
import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.LongStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code brickless explore}: many random schedules; tells the first failure of each kind and how to see it again. */
@Command(name = "explore",
        description = "Runs a program under many thread schedules and reports the first failure of each kind.",
        mixinStandardHelpOptions = true)
final class ExploreCommand implements Callable<Integer> {
    @Mixin
    private RunOptions options;

    @Option(names = "--schedules", paramLabel = "N", defaultValue = "200",
            description = "Number of schedules (default: 200).")
    private int schedules;

    @Option(names = "--jobs", paramLabel = "N", description = "Runs at the same time (default: one per processor).")
    private int jobs = Runtime.getRuntime().availableProcessors();

    @Spec
    private picocli.CommandLine.Model.CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        if (schedules < 1 || jobs < 1) {
            throw new UsageException("--schedules and --jobs must be at least 1");
        }
        long first = options.scheduleSeed == null ? 1 : options.scheduleSeed;
        try (Program program = options.findProgram()) {
            SimulationSettings settings = options.settings();
            Map<String, RunReport> failures = new LinkedHashMap<>();
            Map<String, Long> seeds = new LinkedHashMap<>();
            Map<String, Integer> counts = new LinkedHashMap<>();
            ExecutorService pool = Executors.newFixedThreadPool(jobs);
            try {
                List<Future<RunReport>> runs = LongStream.range(first, first + schedules)
                        .mapToObj(seed -> pool.submit(() -> run(settings, program, seed))).toList();
                for (int i = 0; i < runs.size(); i++) {
                    RunReport report = runs.get(i).get();
                    String kind = failureKind(report);
                    if (!kind.isEmpty()) {
                        counts.merge(kind, 1, Integer::sum);
                        failures.putIfAbsent(kind, report);
                        seeds.putIfAbsent(kind, first + i);
                    }
                }
            } catch (ExecutionException e) {
                throw unwrapped(e.getCause());
            } finally {
                pool.shutdownNow();
            }
            print(failures, seeds, counts);
            return failures.isEmpty() ? 0 : 1;
        }
    }

    private static RuntimeException unwrapped(Throwable cause) {
        if (cause instanceof SetupException) {
            return new UsageException(cause.getMessage());
        }
        return cause instanceof RuntimeException exception ? exception : new IllegalStateException(cause);
    }

    private static RunReport run(SimulationSettings settings, Program program, long seed) {
        var run = new Simulation(settings.toBuilder().scheduleSeed(OptionalLong.of(seed)).build()).start(program);
        run.toEnd();
        return run.report();
    }

    private static String failureKind(RunReport report) {
        if (!report.outcome().successful()) {
            return report.outcome().kind().equals("exited")
                    ? "exited with status " + report.outcome().exitStatus().orElse(0) : report.outcome().kind();
        }
        return report.goalMissed() ? "goal not reached" : "";
    }

    private void print(Map<String, RunReport> failures, Map<String, Long> seeds, Map<String, Integer> counts) {
        var out = spec.commandLine().getOut();
        out.println(schedules + " schedules: "
                + (failures.isEmpty() ? "no failure" : failures.size() + " kinds of failure"));
        failures.forEach((kind, report) -> {
            out.println(kind + ": " + counts.get(kind) + " of " + schedules + ", first with schedule seed "
                    + seeds.get(kind));
            report.outcome().error()
                    .ifPresent(error -> error.lines().limit(20).forEach(line -> out.println("    " + line)));
            out.println("  see it again: " + options.commandLine() + " --schedule-seed " + seeds.get(kind));
        });
        out.flush();
    }
}
