package brickless.kernel;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Whether a host thread that gave the turn away should spin for it before it parks.
 *
 * <p>Waking a parked thread takes some 25 µs on an idle machine, a spinning one notices in less than 1 µs. But
 * spinning is a waste when the others keep the turn for long, and harmful when the host has no processor to spare (for
 * the JIT compiler, say): so each time it was in vain, twice as many waits as before go without it, and nobody spins
 * when there are more runs than pairs of processors. Belongs to the thread that waits.
 */
final class SpinBackOff {
    /** Some 50 µs: about twice the time that waking takes, so that spinning in vain costs no more than it can save. */
    private static final int SPINS = 3_500;
    private static final int PROCESSORS = Runtime.getRuntime().availableProcessors();
    private static final int LONGEST_BACK_OFF = 1 << 10;

    /** Runs in this JVM whose threads take turns. */
    private static final AtomicInteger RUNS = new AtomicInteger();

    private int backOff = 1;
    private int waitsLeft;

    static void runBegins() {
        RUNS.incrementAndGet();
    }

    static void runEnds() {
        RUNS.decrementAndGet();
    }

    /** How many spins the coming wait is worth, 0 = none. */
    int spins() {
        if (waitsLeft > 0) {
            waitsLeft--;
            return 0;
        }
        return 2 * RUNS.get() <= PROCESSORS ? SPINS : 0;
    }

    /** The turn came back while the thread was spinning. */
    void succeeded() {
        backOff = 1;
    }

    /** The thread spun until its patience was over, or until another one wanted to spin. */
    void failed() {
        waitsLeft = backOff;
        backOff = Math.min(LONGEST_BACK_OFF, backOff * 2);
    }
}
