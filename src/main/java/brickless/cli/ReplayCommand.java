package brickless.cli;

import brickless.simulation.FinishedRun;
import brickless.simulation.SetupException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;

/** {@code brickless replay}: opens the report of a finished run. */
@Command(name = "replay", description = "Opens the report of a finished run in the browser.",
        mixinStandardHelpOptions = true)
final class ReplayCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "DIR", description = "Folder with the files of a run, as --out named it.")
    private Path folder;

    @Option(names = "--print-path", description = "Only prints the address of the report.")
    private boolean printPath;

    @ParentCommand
    private Main main;

    @Override
    public Integer call() {
        try {
            Path page = FinishedRun.open(folder).report();
            String address = page.toAbsolutePath().normalize().toUri().toString();
            main.out().println(printPath || !DesktopBrowser.show(page.toAbsolutePath().normalize().toUri())
                    ? address : "opened " + address);
            return 0;
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        }
    }
}
