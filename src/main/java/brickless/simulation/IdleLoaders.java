package brickless.simulation;

import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import brickless.program.Program;
import java.io.IOException;
import java.lang.ref.SoftReference;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Class loaders of runs that are over, for later runs of the same program in this JVM: what the JVM has loaded and
 * compiled is used again.
 *
 * <p>Exactly one run has a loader at a time; parallel runs of a program have several. Bounded: the loader that has been
 * idle longest goes first. Held softly, so that the JVM may drop them when memory gets short. Thread-safe.
 */
final class IdleLoaders {
    private static final int CAPACITY = 8;
    private static final IdleLoaders OF_THE_JVM = new IdleLoaders(CAPACITY);

    private final int capacity;
    /** The one that was used last comes first. */
    private final Deque<SoftReference<RobotClassLoader>> idle = new ArrayDeque<>();

    private long reused;

    IdleLoaders(int capacity) {
        this.capacity = capacity;
    }

    /** Those of the JVM. */
    static IdleLoaders ofTheJvm() {
        return OF_THE_JVM;
    }

    /**
     * Takes a loader out that has the classes of a program.
     *
     * @param application reads the classes of a program without a class path of its own
     * @throws IOException if the class path cannot be read; the message names the directory or jar
     */
    synchronized Optional<RobotClassLoader> take(Program program, ClassLoader application) throws IOException {
        for (Iterator<SoftReference<RobotClassLoader>> all = idle.iterator(); all.hasNext();) {
            RobotClassLoader loader = all.next().get();
            if (loader == null) {
                all.remove();
            } else if (fits(loader, program, application)) {
                all.remove();
                reused++;
                return Optional.of(loader);
            }
        }
        return Optional.empty();
    }

    private static boolean fits(RobotClassLoader loader, Program program, ClassLoader application) throws IOException {
        return program.classPath().isEmpty() ? loader.readsFrom(application, LoadingRules.standard())
                : loader.reopen(program.classPath());
    }

    /** Puts a closed loader in that nobody uses any more. */
    synchronized void put(RobotClassLoader loader) {
        idle.addFirst(new SoftReference<>(loader));
        while (idle.size() > capacity) {
            idle.removeLast();
        }
    }

    /** Forgets all. */
    synchronized void clear() {
        idle.clear();
    }

    /** Shows all that are idle. */
    synchronized void forEach(Consumer<RobotClassLoader> action) {
        idle.stream().map(SoftReference::get).filter(Objects::nonNull).forEach(action);
    }

    /** How many are idle. */
    synchronized int size() {
        return idle.size();
    }

    /** How often a loader was taken out. */
    synchronized long reused() {
        return reused;
    }
}
