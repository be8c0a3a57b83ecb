package brickless.kernel;

/** In line, in slices of 10 ms; no preemption before monitors. */
final class RoundRobin implements Schedule {
    static final long SLICE_NANOS = 10_000_000L;

    @Override
    public Fibre next(FibreQueue ready) {
        return ready.poll();
    }

    @Override
    public long sliceNanos() {
        return SLICE_NANOS;
    }

    @Override
    public boolean preemptsBeforeMonitor() {
        return false;
    }
}
