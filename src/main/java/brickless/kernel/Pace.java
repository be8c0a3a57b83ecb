package brickless.kernel;

/**
 * Simulated time that follows the host's clock: which steps are due. When the host falls behind by more than {@value
 * #LONGEST_BURST} steps (it was busy, or suspended) the rest is dropped: the simulation is late from then on, but
 * never races. Not thread-safe.
 */
final class Pace {
    /** Assumption: catching up a tenth of a second goes unnoticed at the usual step of 2 ms. */
    static final int LONGEST_BURST = 50;

    private final long stepNanos;
    /** Host time at simulated time 0, later by all that was dropped. */
    private long originNanos;
    private long steps;

    Pace(long stepNanos, long hostNanos) {
        this.stepNanos = stepNanos;
        this.originNanos = hostNanos;
    }

    /** How many steps are due; drops what is too much. */
    int due(long hostNanos) {
        long due = (hostNanos - originNanos) / stepNanos - steps;
        if (due > LONGEST_BURST) {
            originNanos += (due - LONGEST_BURST) * stepNanos;
        }
        return (int) Math.min(due, LONGEST_BURST);
    }

    /** Counts a step and returns its simulated time. */
    long step() {
        return ++steps * stepNanos;
    }

    /** Host nanoseconds until the next step, not positive if it is due. */
    long untilNextStep(long hostNanos) {
        return originNanos + (steps + 1) * stepNanos - hostNanos;
    }

    /** Simulated time: never beyond a step that has not been made, never backwards. */
    long now(long hostNanos) {
        long sinceStep = hostNanos - originNanos - steps * stepNanos;
        return steps * stepNanos + Math.max(0, Math.min(sinceStep, stepNanos));
    }
}
