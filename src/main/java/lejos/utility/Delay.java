package lejos.utility;

/** Waits that cannot be interrupted. */
public class Delay {
    private static final long NANOS_PER_MICRO = 1_000;
    private static final long NANOS_PER_MILLI = 1_000_000;

    /** Creates an object nobody needs: all methods are static. */
    public Delay() {}

    /**
     * Waits at least so many milliseconds; returns at once if the number is not above 0. An interrupt does not end the
     * wait; it stays marked.
     */
    public static void msDelay(long period) {
        if (period <= 0) {
            return;
        }
        long end = System.currentTimeMillis() + period;
        boolean interrupted = false;
        long left = period;
        while (left > 0) {
            try {
                Thread.sleep(left);
            } catch (InterruptedException e) {
                interrupted = true;
            }
            left = end - System.currentTimeMillis();
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits so many microseconds, the last fraction of a millisecond without giving up the processor. */
    public static void usDelay(long period) {
        nsDelay(period * NANOS_PER_MICRO);
    }

    /** Waits so many nanoseconds, the last fraction of a millisecond without giving up the processor. */
    public static void nsDelay(long period) {
        long end = System.nanoTime() + period;
        msDelay(period / NANOS_PER_MILLI);
        while (end - System.nanoTime() > 0) {
            // spins, as documented
        }
    }
}
