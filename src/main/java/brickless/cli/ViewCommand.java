package brickless.cli;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;

/** {@code brickless view}: a run to watch and to touch. */
@Command(name = "view", description = "Runs a program in the browser, to watch and to touch.",
        mixinStandardHelpOptions = true)
final class ViewCommand implements Callable<Integer> {
    @Mixin
    private RunOptions options;

    @Mixin
    private ViewFlags flags;

    @Option(names = "--out", paramLabel = "DIR",
            description = "Folder for the files of the run (default: build/simulations/<main>).")
    private Path out;

    @Option(names = "--json", description = "Prints one JSON object as the last line.")
    private boolean json;

    @ParentCommand
    private Main main;

    @Override
    public Integer call() throws InterruptedException {
        options.forPeople();
        return new Showing(main.out()).show(options, flags, Optional.ofNullable(out), json);
    }
}
