package brickless.loading;

import brickless.kernel.Kernel;
import brickless.kernel.KernelListener;
import brickless.kernel.KernelSettings;
import brickless.kernel.ProgramEnd;
import brickless.kernel.hooks.ThrowableText;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * One run of a program from the test class path on a kernel without a brick.
 *
 * @param end how it ended
 * @param output what it printed, both streams
 * @param traceHash SHA-256 over every scheduling decision with its time, and the output
 */
record ProgramRun(ProgramEnd end, String output, String traceHash) {
    static ProgramRun of(String mainClass, KernelSettings settings, String input) {
        try (RobotClassLoader loader = RobotClassLoader.ofApplication()) {
            return run(loader, mainClass, settings, input);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    static ProgramRun run(RobotClassLoader loader, String mainClass, KernelSettings settings, String input) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream console = new PrintStream(bytes, true, StandardCharsets.UTF_8);
        Kernel kernel = new Kernel(settings);
        kernel.bind(loader.bind(kernel));
        kernel.setStreams(console, console, new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)));
        Trace trace = new Trace(console);
        kernel.listen(trace);
        Thread main = loader.mainThread(mainClass);
        ProgramEnd end = kernel.run(main, main);
        String output = bytes.toString(StandardCharsets.UTF_8);
        return new ProgramRun(end, output, trace.hash(end, output));
    }

    /** Feeds a digest. */
    private static final class Trace implements KernelListener {
        private final StringBuilder text = new StringBuilder();
        private final PrintStream console;

        Trace(PrintStream console) {
            this.console = console;
        }

        @Override
        public void scheduled(long timeNanos, int fibre) {
            text.append(timeNanos).append(" run ").append(fibre).append('\n');
        }

        @Override
        public void started(long timeNanos, Thread thread) {
            text.append(timeNanos).append(" start ").append(thread.getName()).append('\n');
        }

        @Override
        public void ended(long timeNanos, Thread thread) {
            text.append(timeNanos).append(" end ").append(thread.getName()).append('\n');
        }

        @Override
        public void uncaught(Thread thread, Throwable failure) {
            console.print("Exception in thread \"" + thread.getName() + "\" " + ThrowableText.trace(failure));
        }

        String hash(ProgramEnd end, String output) {
            text.append(end.kind()).append(end.timeNanos()).append(output);
            try {
                byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
                return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
            } catch (NoSuchAlgorithmException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
    }
}
