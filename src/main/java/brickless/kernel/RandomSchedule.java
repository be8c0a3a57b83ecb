package brickless.kernel;

import java.util.Random;

/**
 * A schedule drawn from a seed, to find races and lock-order deadlocks: any ready fibre is next, every fourth slice
 * is a very short one, and one in six entries of monitors is preceded by a switch. The same seed gives the same
 * schedule.
 */
final class RandomSchedule implements Schedule {
    private static final int SHORT_SLICE_ONE_IN = 4;
    private static final int SHORTEST_SLICE_NANOS = 200;
    private static final int SHORT_SLICE_SPAN_NANOS = 20_000;
    private static final int PREEMPTION_ONE_IN = 6;

    private final Random random;

    RandomSchedule(long seed) {
        random = new Random(Seeds.spread(seed));
    }

    @Override
    public Fibre next(FibreQueue ready) {
        return ready.size() == 1 ? ready.poll() : ready.poll(random.nextInt(ready.size()));
    }

    @Override
    public long sliceNanos() {
        if (random.nextInt(SHORT_SLICE_ONE_IN) != 0) {
            return RoundRobin.SLICE_NANOS;
        }
        return SHORTEST_SLICE_NANOS + random.nextInt(SHORT_SLICE_SPAN_NANOS);
    }

    @Override
    public boolean preemptsBeforeMonitor() {
        return random.nextInt(PREEMPTION_ONE_IN) == 0;
    }
}
