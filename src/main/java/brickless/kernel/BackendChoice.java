package brickless.kernel;

/** Where the stacks of program threads live; no choice changes what a program does. */
public enum BackendChoice {
    /** Continuations where this JVM grants access to them, else threads. */
    AUTO,
    /** One platform thread for each program thread, one at a time: any JDK from 17, no options needed. */
    THREADS,
    /** {@code jdk.internal.vm.Continuation}: JDK 21 or later, started with {@link #CONTINUATION_OPTIONS}. */
    CONTINUATIONS;

    /**
     * The JVM options that grant access to continuations, and to the thread locals that each program thread must have
     * of its own (a jar's manifest says {@code Add-Exports: java.base/jdk.internal.vm} and {@code Add-Opens:
     * java.base/java.lang}).
     */
    public static final String CONTINUATION_OPTIONS =
            "--add-exports java.base/jdk.internal.vm=ALL-UNNAMED --add-opens java.base/java.lang=ALL-UNNAMED";

    /** Whether {@link #CONTINUATIONS} works in this JVM. */
    public static boolean continuationsAvailable() {
        return ContinuationAccess.OBSTACLE == null;
    }

    Backend open(long stackBytes) {
        if (this == THREADS || this == AUTO && !continuationsAvailable()) {
            return new ThreadBackend(stackBytes);
        }
        if (!continuationsAvailable()) {
            throw new UnsupportedOperationException("continuations need JDK 21 or later, started with "
                    + CONTINUATION_OPTIONS + " (" + ContinuationAccess.OBSTACLE + ")");
        }
        return new ContinuationBackend(stackBytes);
    }
}
