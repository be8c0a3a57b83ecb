package brickless.kernel;

import java.util.List;

/** Argument source: the back-ends that this JVM can run. */
final class Backends {
    private Backends() {
    }

    static List<BackendChoice> available() {
        return BackendChoice.continuationsAvailable()
                ? List.of(BackendChoice.THREADS, BackendChoice.CONTINUATIONS)
                : List.of(BackendChoice.THREADS);
    }
}
