package brickless.loading;

import brickless.kernel.Ensemble;
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
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

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
        return together(List.of(loader.newRobot()), mainClass, List.of(settings), input).get(0);
    }

    /** Runs a program in several robots, which meet at the steps. */
    static List<ProgramRun> together(List<RobotContext> robots, String mainClass, List<KernelSettings> settings,
            String input) {
        List<Kernel> kernels = new ArrayList<>();
        List<ByteArrayOutputStream> outputs = new ArrayList<>();
        List<Trace> traces = new ArrayList<>();
        for (RobotContext robot : robots) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            PrintStream console = new PrintStream(bytes, true, StandardCharsets.UTF_8);
            Kernel kernel = new Kernel(settings.get(kernels.size()));
            kernel.bind(robot.bind(kernel));
            kernel.beforeTurn(robot::enter);
            kernel.setStreams(console, console, new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)));
            Trace trace = new Trace(console);
            kernel.listen(trace);
            Thread main = robot.during(() -> robot.loader().mainThread(mainClass));
            kernel.main(main, main);
            kernels.add(kernel);
            outputs.add(bytes);
            traces.add(trace);
        }
        List<ProgramEnd> ends = new Ensemble(kernels, kernels.size() == 1 ? null : time -> { }).run();
        List<ProgramRun> runs = new ArrayList<>();
        for (int i = 0; i < ends.size(); i++) {
            String output = outputs.get(i).toString(StandardCharsets.UTF_8);
            runs.add(new ProgramRun(ends.get(i), output, traces.get(i).hash(ends.get(i), output)));
        }
        return runs;
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
