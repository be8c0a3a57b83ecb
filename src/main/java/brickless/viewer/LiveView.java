package brickless.viewer;

import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import java.io.IOException;
import java.net.URI;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * A run that people watch and touch in a browser. It is the ordinary deterministic run, paced to the wall clock:
 * touches become stimuli at the present simulated time, and the stimuli file of the session repeats it headless, with
 * the same trace.
 *
 * <p>The run begins when the first viewer is there and stands still when the view is closed. Thread-safe.
 */
public final class LiveView implements AutoCloseable {
    private static final long LOOK_AT_FILES_MILLIS = 500;

    private final Driver driver;
    private final Thread thread;
    private final ViewServer server;
    private final ScheduledExecutorService files;
    private boolean closed;

    private LiveView(RunSource source, ViewOptions options) throws IOException {
        RunSource.Prepared first = source.prepare(OptionalLong.empty());
        Session session = session(first);
        driver = new Driver(session, options.speed());
        Restarter restarter = new Restarter(source, first, driver);
        boolean bound = false;
        try {
            server = new ViewServer(options, driver, restarter);
            bound = true;
        } finally {
            if (!bound) {
                session.close();
            }
        }
        thread = new Thread(driver, "brickless-view-driver");
        files = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread watch = new Thread(work, "brickless-view-files");
            watch.setDaemon(true);
            return watch;
        });
        thread.start();
        server.start();
        files.scheduleWithFixedDelay(restarter::lookAtFiles, LOOK_AT_FILES_MILLIS, LOOK_AT_FILES_MILLIS,
                TimeUnit.MILLISECONDS);
    }

    private static Session session(RunSource.Prepared first) {
        boolean fits = false;
        try {
            Session session = new Session(1, first);
            fits = true;
            return session;
        } finally {
            if (!fits) {
                first.program().close();
            }
        }
    }

    /**
     * Prepares a run and opens it to viewers.
     *
     * @throws SetupException if program, world and robot do not fit together, or the port is taken
     */
    public static LiveView open(RunSource source, ViewOptions options) {
        try {
            return new LiveView(source, options);
        } catch (IOException e) {
            throw new SetupException("port " + options.port() + " cannot be opened on this machine: " + e.getMessage());
        }
    }

    /** The address of the page, with the token in it. */
    public URI address() {
        return URI.create(server.address());
    }

    /**
     * Waits until somebody closes the view.
     *
     * @return the figures of the last run, empty if it never began
     */
    public Optional<RunReport> awaitEnd() throws InterruptedException {
        try {
            return driver.result().get();
        } catch (ExecutionException e) {
            throw new IllegalStateException("the simulation failed", e.getCause());
        }
    }

    /**
     * Ends the run if it has not ended, writes its files, tells the viewers and closes the server. Threads are gone
     * when it returns.
     */
    @Override
    public void close() {
        synchronized (this) {
            if (closed) {
                return;
            }
            closed = true;
        }
        files.shutdownNow();
        driver.submit(driver::stop);
        boolean interrupted = false;
        while (!ended()) {
            interrupted |= Thread.interrupted();
        }
        server.stop();
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean ended() {
        try {
            thread.join();
            return files.awaitTermination(1, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}
