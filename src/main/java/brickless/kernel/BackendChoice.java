package brickless.kernel;

/** Where the stacks of program threads live; no choice changes what a program does. */
public enum BackendChoice {
    /** The fastest that this JVM offers. */
    AUTO,
    /** One platform thread for each program thread, one at a time: any JDK from 17, no options needed. */
    THREADS;

    Backend open(long stackBytes) {
        return new ThreadBackend(stackBytes);
    }
}
