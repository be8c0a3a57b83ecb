package brickless.kernel;

import java.util.function.BooleanSupplier;

/**
 * The processor a robot's program runs on, as device models and sockets see it: a clock, a way to charge time for a
 * call, and a way to block.
 *
 * <p>The virtual-time kernel implements it with fibres; live mode implements it with real threads and the wall clock.
 * Methods that charge or block are called on a program thread; {@link Signal#raise()} also from the physics step.
 */
public interface Processor {
    /** Nanoseconds since the program's start. */
    long nowNanos();

    /** Charges the running program thread for work; other threads and physics steps may run before it returns. */
    void charge(long nanos);

    /**
     * Tells that the running program thread did something that matters (a motor command …), so that its next {@code
     * Thread.yield} is charged as a first one again. Blocking counts by itself.
     */
    default void progress() {
    }

    /** A new signal that threads of this program can wait for. */
    Signal newSignal();

    /** Something a program thread can wait for. */
    interface Signal {
        /** Wakes every thread that waits now. Has no effect on later waits. */
        void raise();

        /**
         * Blocks the calling program thread until {@link #raise()}; interrupts are ignored and kept.
         *
         * @param timeoutNanos longest wait in nanoseconds, 0 = for ever
         * @return true if raised, false if the time ran out
         */
        boolean await(long timeoutNanos);

        /**
         * Like {@link #await(long)} but gives up when the thread is interrupted.
         *
         * @throws InterruptedException if interrupted before or during the wait
         */
        boolean awaitInterruptibly(long timeoutNanos) throws InterruptedException;

        /**
         * Blocks the calling program thread while a condition holds, looking at it again after each {@link #raise()};
         * no raise between a look and the wait is lost. Interrupts are ignored and kept.
         */
        default void awaitWhile(BooleanSupplier condition) {
            while (condition.getAsBoolean()) {
                await(0);
            }
        }
    }
}
