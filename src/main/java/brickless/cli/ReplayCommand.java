package brickless.cli;

import brickless.simulation.FinishedRun;
import brickless.simulation.SetupException;
import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
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
            String address = page.toAbsolutePath().normalize().toUri().toString();
            main.out().println(printPath || !opened(page) ? address : "opened " + address);
            return 0;
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        }
    }

    /** Shows the page in the browser; a machine without a screen or a browser has to do with the address. */
    private static boolean opened(Path page) {
        if (GraphicsEnvironment.isHeadless() || !Desktop.isDesktopSupported() || !Desktop.getDesktop().isSupported(Desktop.Action.BROWSE)) {
            return false;
        }
        try {
            Desktop.getDesktop().browse(page.toAbsolutePath().normalize().toUri());
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
