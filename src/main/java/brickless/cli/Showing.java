package brickless.cli;

import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import brickless.viewer.LiveView;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;

/** Shows a run in the browser until somebody presses Ctrl-C, which ends it and writes its files. */
final class Showing {
    private final PrintStream out;

    Showing(PrintStream out) {
        this.out = out;
    }

    /** Returns the exit status of the command. */
    int show(RunOptions options, ViewFlags flags, Optional<Path> folder, boolean json) throws InterruptedException {
        CountDownLatch done = new CountDownLatch(1);
        try (LiveView view = LiveView.open(new LiveSource(options, folder, out), flags.options())) {
            Thread end = new Thread(() -> end(view, done), "brickless-view-end");
            Runtime.getRuntime().addShutdownHook(end);
            String address = view.address().toString();
            boolean opened = flags.browser() && DesktopBrowser.show(view.address());
            out.println((opened ? "opened " : "open ") + address + " (Ctrl-C ends)");
            out.flush();
            return report(view.awaitEnd(), json);
        } catch (SetupException e) {
            throw new UsageException(e.getMessage());
        } finally {
            done.countDown();
        }
    }

    private int report(Optional<RunReport> report, boolean json) {
        report.ifPresent(figures -> out.println(json ? figures.json() : figures.text()));
        out.flush();
        return report.map(RunReport::exitStatus).orElse(0);
    }

    /** The JVM is told to end: it may when the figures are printed. */
    private static void end(LiveView view, CountDownLatch done) {
        view.close();
        try {
            done.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
