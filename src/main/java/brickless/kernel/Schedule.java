package brickless.kernel;

import java.util.OptionalLong;

/** Who runs next, for how long, and whether a fibre loses the processor before it enters a monitor. */
interface Schedule {
    /** Takes the next fibre out of a queue that is not empty. */
    Fibre next(FibreQueue ready);

    /** Length of the time slice that begins. */
    long sliceNanos();

    /** Whether to switch before the running fibre enters a monitor. */
    boolean preemptsBeforeMonitor();

    /** Round-robin, or a random schedule with a seed. */
    static Schedule of(OptionalLong seed) {
        return seed.isPresent() ? new RandomSchedule(seed.getAsLong()) : new RoundRobin();
    }
}
