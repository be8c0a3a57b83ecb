package brickless.viewer;

import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/**
 * Prepares runs anew while the old one goes on, and looks after files that change meanwhile. What cannot be prepared is
 * told to the viewers, and the old run stays. Guarded by its own monitor.
 */
final class Restarter {
    private final RunSource source;
    private final Driver driver;
    private FileWatch watch;
    private OptionalLong lastSeed = OptionalLong.empty();

    Restarter(RunSource source, RunSource.Prepared first, Driver driver) {
        this.source = source;
        this.driver = driver;
        this.watch = new FileWatch(first.files());
    }

    /**
     * Prepares a run and puts it in the place of the present one.
     *
     * @param seed another seed; empty: the last one
     * @throws RefusedException if it cannot be prepared
     */
    CompletableFuture<Void> restart(OptionalLong seed) {
        RunSource.Prepared prepared = prepare(seed);
        return driver.submit(() -> driver.replace(prepared)).whenComplete((done, refused) -> {
            if (refused != null) {
                prepared.program().close();
            }
        });
    }

    private synchronized RunSource.Prepared prepare(OptionalLong seed) {
        try {
            OptionalLong wanted = seed.isPresent() ? seed : lastSeed;
            RunSource.Prepared prepared = source.prepare(wanted);
            FileWatch fresh = new FileWatch(prepared.files());
            tryOut(prepared);
            watch = fresh;
            lastSeed = wanted;
            return prepared;
        } catch (SetupException e) {
            driver.submit(() -> driver.say(e.getMessage()));
            throw new RefusedException(e.getMessage());
        }
    }

    /** Builds the run once, without files, because the old one is gone when it is built for good. */
    private static void tryOut(RunSource.Prepared prepared) {
        boolean fits = false;
        try {
            new Simulation(prepared.settings().toBuilder().out(Optional.empty()).build())
                    .start(prepared.program()).close();
            fits = true;
        } finally {
            if (!fits) {
                prepared.program().close();
            }
        }
    }

    /** Looks at the files once and tells what changed, if that is something else than before. */
    synchronized void lookAtFiles() {
        List<Path> now = watch.changed();
        driver.submit(() -> driver.filesChanged(now));
    }
}
