package brickless.cli;

import brickless.program.Program;
import brickless.simulation.Run;
import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;

/** {@code brickless run}: one headless run, a summary, and the files of the run. */
@Command(name = "run", description = "Runs a program headless and prints a summary.", mixinStandardHelpOptions = true)
final class RunCommand implements Callable<Integer> {
    @Mixin
    private RunOptions options;

    @Option(names = "--out", paramLabel = "DIR",
            description = "Folder for the files of the run (default: build/simulations/<main>).")
    private Path out;

    @Option(names = "--json", description = "Prints one JSON object as the last line.")
    private boolean json;

    @Option(names = "--verbose", description = "Logs arbitration and scheduling.")
    private boolean verbose;

    @Option(names = "--view", description = "Shows the run in the browser while it runs, see view.")
    private boolean view;

    @Mixin
    private ViewFlags flags;

    @ParentCommand
    private Main main;

    @Override
    public Integer call() throws Exception {
        if (verbose) {
            System.setProperty("org.slf4j.simpleLogger.defaultLogLevel", "debug");
        }
        if (view) {
            return new Showing(main.out()).show(options, flags, Optional.ofNullable(out), json);
        }
        try (Program program = options.findProgram()) {
            SimulationSettings settings = options.settings();
            Path folder = out != null ? out : Path.of("build", "simulations", program.simpleName());
            Simulation simulation = new Simulation(settings.toBuilder().console(main.out())
                    .out(Optional.of(folder)).build());
            PrintStream stream = main.out();
            Run run = simulation.start(program);
            run.toEnd();
            RunReport report = run.report();
            report.outcome().error().ifPresent(this::explain);
            stream.println(json ? report.json() : report.text());
            stream.flush();
            return report.exitStatus();
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        }
    }

    private void explain(String error) {
        main.err().println(error);
        main.err().println("run it again: " + options.commandLine()
                + (options.scheduleSeed == null ? "" : " --schedule-seed " + options.scheduleSeed));
        main.err().flush();
    }
}
