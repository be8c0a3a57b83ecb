package brickless.cli;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code brickless}: runs leJOS EV3 programs without a brick. */
@Command(name = "brickless", description = "Runs leJOS EV3 programs without a brick.", mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class, subcommands = {RunCommand.class, ViewCommand.class, ReplayCommand.class,
                CheckCommand.class, ExploreCommand.class, SweepCommand.class})
public final class Main implements Runnable {
    /** Exit status for bad input. */
    static final int USAGE = 2;

    @CommandLine.Spec
    private CommandLine.Model.CommandSpec spec;

    private final PrintStream out;
    private final PrintStream err;

    private Main(PrintStream out, PrintStream err) {
        this.out = out;
        this.err = err;
    }

    /** Runs a command and ends the JVM with its exit status. */
    public static void main(String[] args) {
        System.exit(run(System.out, System.err, args));
    }

    /** Runs a command that prints to these streams; returns its exit status. */
    static int run(PrintStream out, PrintStream err, String... args) {
        CommandLine line = new CommandLine(new Main(out, err));
        line.setOut(new PrintWriter(out, true));
        line.setErr(new PrintWriter(err, true));
        line.setParameterExceptionHandler((failure, arguments) -> usage(failure.getCommandLine(), explain(failure)));
        line.setExecutionExceptionHandler((failure, command, parsed) -> {
            if (failure instanceof UsageException) {
                return usage(command, failure.getMessage());
            }
            throw failure;
        });
        return line.execute(args);
    }

    /** Where results and the program's output go. */
    PrintStream out() {
        return out;
    }

    /** Where explanations of failures go. */
    PrintStream err() {
        return err;
    }

    /** One line; for an option that is not known, which ones it may have been meant to be. */
    private static String explain(CommandLine.ParameterException failure) {
        if (failure instanceof CommandLine.UnmatchedArgumentException unmatched && unmatched.isUnknownOption()) {
            List<String> meant = unmatched.getSuggestions();
            List<String> all = failure.getCommandLine().getCommandSpec().options().stream()
                    .map(option -> option.longestName()).toList();
            return "unknown option " + unmatched.getUnmatched().get(0) + "; "
                    + (meant.isEmpty() ? "allowed: " + String.join(", ", all)
                    : "did you mean " + String.join(" or ", meant) + "?");
        }
        return failure.getMessage();
    }

    private static int usage(CommandLine command, String message) {
        PrintWriter err = command.getErr();
        err.println(command.getCommandSpec().qualifiedName() + ": " + message.replaceAll("\\R\\s*(?=Possible)", " "));
        err.flush();
        return USAGE;
    }

    @Override
    public void run() {
        throw new CommandLine.ParameterException(spec.commandLine(),
                "which command? one of " + String.join(", ", spec.subcommands().keySet())
                + "; 'brickless --help' explains");
    }

    /** Version of the jar. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {"brickless " + (version == null ? "(development)" : version)};
        }
    }
}
