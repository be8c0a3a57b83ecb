package brickless.kernel;

/** Hears what the kernel does; a listener must not change the course of a run. */
public interface KernelListener {
    /**
     * A program thread got the processor.
     *
     * @param timeNanos virtual time
     * @param fibre number of the thread in order of starting, the main thread is 1
     */
    default void scheduled(long timeNanos, int fibre) {
    }

    /** A program thread was started (it has not run yet). */
    default void started(long timeNanos, Thread thread) {
    }

    /** A program thread ended. */
    default void ended(long timeNanos, Thread thread) {
    }

    /**
     * A program thread ended by an exception for which the program has no handler; the run will end as {@code
     * failed}. Called on that program thread, before it ends: may charge and block.
     */
    default void uncaught(Thread thread, Throwable failure) {
    }
}
