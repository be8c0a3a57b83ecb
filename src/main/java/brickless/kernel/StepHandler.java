package brickless.kernel;

/**
 * What happens at every multiple of the physics step: motors, bodies, sensors, traces.
 *
 * <p>Called on the running program thread's stack, with the clock standing exactly at the boundary. It may raise
 * signals, schedule events and end a run ({@link Kernel#goalReached()} …); it must not charge or block. What it
 * throws ends the run and comes out of {@link Kernel#run} or {@link Ensemble#run}.
 */
@FunctionalInterface
public interface StepHandler {
    /** Steps the world to {@code timeNanos}, a positive multiple of the step length. */
    void step(long timeNanos);
}
