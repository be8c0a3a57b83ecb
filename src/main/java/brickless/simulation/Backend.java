package brickless.simulation;

/** How the threads of a program are carried. Traces do not depend on it. */
public enum Backend {
    /** Continuations where the JDK offers them and grants access, else platform threads. */
    AUTO,
    /** One platform thread per program thread. */
    THREADS,
    /** One continuation per program thread; JDK 21 and newer. */
    CONTINUATION
}
