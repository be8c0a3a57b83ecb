package brickless.cli;

import brickless.simulation.FinishedRun;
import brickless.simulation.SetupException;
import java.net.URI;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;

/** {@code brickless replay}: opens the report of a finished run. */
@Command(name = "replay", description = "Opens the report of a finished run in the browser.", mixinStandardHelpOptions = true)
final class ReplayCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "DIR", description = "Folder with the files of a run, as --out named it.")
    private Path folder;

    @Option(names = "--print-path", description = "Only prints the address of the report.")
    private boolean printPath;

    @ParentCommand
    private Main main;

    @Override public Integer call() {
        try {
            Path page = FinishedRun.open(folder).report();
            URI address = page.toAbsolutePath().normalize().toUri();
            boolean shown = !printPath && new BrowserWindow(System.getenv(), System.getProperty("os.name")).show(address);
            main.out().println((shown ? "opened " : "") + address);
            return 0;
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        }
    }
}
