package brickless.kernel;

import java.util.function.Consumer;

/**
 * Stacks and the switch between them, nothing else: who runs is decided by {@link Scheduler}. {@link #create}, {@link
 * #switchTo} and {@link #finish} are called on the running fibre's stack (for main threads, {@code create} by the
 * host), the others by the host.
 */
interface Backend {
    /** For reports. */
    String name();

    /**
     * Prepares a stack that will execute {@link Fibre#run}; inheritable thread locals come from the calling fibre.
     */
    void create(Fibre fibre);

    /**
     * Runs the first fibre and all it switches to, on host threads of the back-end.
     *
     * @param onFailure told when the host cannot go on (no more threads …) or the kernel failed; must abandon the run
     */
    void start(Fibre first, Consumer<Throwable> onFailure);

    /** Waits until {@link #finish} ended the run, or it was abandoned. */
    void awaitEnd() throws InterruptedException;

    /**
     * Leaves {@code from}, which calls this, and goes on with {@code to}; returns when {@code from} is switched to
     * again.
     */
    void switchTo(Fibre from, Fibre to);

    /** The last act of {@code from}: goes on with {@code to}, or ends the run if it is null. */
    void finish(Fibre from, Fibre to);

    /** The frames of a fibre that has begun, innermost first. */
    StackTraceElement[] stackOf(Fibre fibre);

    /** The host thread that a fibre is on now, null if it is on none; from any thread. */
    Thread hostThreadOf(Fibre fibre);

    /** Gives up the running fibre: {@link #awaitEnd} returns, waiting stacks unwind by {@code ProgramKilled}. */
    void abandon();
}
