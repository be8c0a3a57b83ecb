package brickless.kernel.hooks;

import java.io.File;
import java.io.IOException;
import java.util.List;

/**
 * Other programs that rewritten code starts: there are none on a simulated brick, and the host's are no concern of a
 * robot. Without a kernel they start. Per robot.
 */
public final class ProcessHooks {
    private ProcessHooks() {}

    /** {@code builder.start()}. */
    public static Process start(ProcessBuilder builder) throws IOException {
        List<String> command = builder.command();
        if (FileHooks.files() != null && !command.isEmpty()) {
            throw new IOException("Cannot run program \"" + command.get(0) + "\": error=2, No such file or directory");
        }
        return builder.start();
    }

    /** {@code runtime.exec(command)}. */
    public static Process exec(Runtime runtime, String command) throws IOException {
        return exec(runtime, command, null, null);
    }

    /** {@code runtime.exec(command, environment)}. */
    public static Process exec(Runtime runtime, String command, String[] environment) throws IOException {
        return exec(runtime, command, environment, null);
    }

    /** {@code runtime.exec(command, environment, folder)}. */
    public static Process exec(Runtime runtime, String command, String[] environment, File folder)
            throws IOException {
        if (command.isBlank()) {
            throw new IllegalArgumentException("Empty command");
        }
        return exec(runtime, command.strip().split("\\s+"), environment, folder);
    }

    /** {@code runtime.exec(words)}. */
    public static Process exec(Runtime runtime, String[] words) throws IOException {
        return exec(runtime, words, null, null);
    }

    /** {@code runtime.exec(words, environment)}. */
    public static Process exec(Runtime runtime, String[] words, String[] environment) throws IOException {
        return exec(runtime, words, environment, null);
    }

    /** {@code runtime.exec(words, environment, folder)}. */
    public static Process exec(Runtime runtime, String[] words, String[] environment, File folder)
            throws IOException {
        return FileHooks.files() == null ? runtime.exec(words, environment, folder) : start(new ProcessBuilder(words));
    }
}
