package brickless.viewer;

/** How many simulated seconds pass in a second, measured over about a second. Owned by the driver. */
final class RateMeter {
    private static final long PERIOD_NANOS = 1_000_000_000;
    /** Shorter measurements say little. */
    private static final long LEAST_NANOS = PERIOD_NANOS / 2;

    private long wallNanos = System.nanoTime();
    private long simulatedNanos;
    private long reportedNanos = wallNanos;
    private double rate;

    /** A run begins. */
    void restart() {
        wallNanos = System.nanoTime();
        simulatedNanos = 0;
    }

    /** When the next report is due at the latest. */
    long nextReportNanos() {
        return reportedNanos + PERIOD_NANOS;
    }

    /** The present rate. */
    double report(long nowNanos, long simulated) {
        reportedNanos = nowNanos;
        long passed = nowNanos - wallNanos;
        if (passed >= LEAST_NANOS) {
            rate = (double) (simulated - simulatedNanos) / passed;
            wallNanos = nowNanos;
            simulatedNanos = simulated;
        }
        return rate;
    }
}
