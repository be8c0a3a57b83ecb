package brickless.cli;

import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code brickless}: runs leJOS EV3 programs without a brick. */
@Command(name = "brickless", description = "Runs leJOS EV3 programs without a brick.", mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class, subcommands = {RunCommand.class, ExploreCommand.class})
public final class Main implements Runnable {
    /** Exit status for bad input. */
    static final int USAGE = 2;

    @CommandLine.Spec
    private CommandLine.Model.CommandSpec spec;

    /** Runs a command and ends the JVM with its exit status. */
    public static void main(String[] args) {
        System.exit(run(args));
    }

    /** Runs a command. */
    static int run(String... args) {
        CommandLine line = new CommandLine(new Main());
        line.setParameterExceptionHandler((failure, arguments) -> usage(failure.getCommandLine(), failure.getMessage()));
        line.setExecutionExceptionHandler((failure, command, parsed) -> {
            if (failure instanceof UsageException) {
                return usage(command, failure.getMessage());
            }
            throw failure;
        });
        return line.execute(args);
    }

    private static int usage(CommandLine command, String message) {
        PrintWriter err = command.getErr();
        err.println(command.getCommandSpec().qualifiedName() + ": " + message.replaceAll("\\R\\s*(?=Possible)", " "));
        err.flush();
        return USAGE;
    }

    @Override public void run() {
        throw new CommandLine.ParameterException(spec.commandLine(), "which command? one of " + String.join(", ", spec.subcommands().keySet())
                + "; 'brickless --help' explains");
    }

    /** Version of the jar. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {"brickless " + (version == null ? "(development)" : version)};
        }
    }
}
