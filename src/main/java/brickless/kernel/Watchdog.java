package brickless.kernel;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Ends a run whose program does not enter the kernel for a long host time, which only a loop wholly inside code that
 * is not rewritten (the JDK's) can do. Counts looks without a heartbeat instead of reading a clock, so that a machine
 * that slept does not look like a runaway.
 */
final class Watchdog {
    static final int LOOKS = 10;

    private final Heartbeat heartbeat;
    private final Runnable onRunaway;
    private final CountDownLatch stopped = new CountDownLatch(1);

    /** Owned by the watching thread. */
    private long last = -1;
    private int stale;

    Watchdog(Heartbeat heartbeat, Runnable onRunaway) {
        this.heartbeat = heartbeat;
        this.onRunaway = onRunaway;
    }

    /** Begins to watch, in a daemon thread; with a patience of 0 nobody watches. */
    static Watchdog watch(Heartbeat heartbeat, long patienceNanos, Runnable onRunaway) {
        Watchdog watchdog = new Watchdog(heartbeat, onRunaway);
        if (patienceNanos > 0) {
            Thread thread = new Thread(() -> watchdog.watch(Math.max(1, patienceNanos / LOOKS)), "brickless watchdog");
            thread.setDaemon(true);
            thread.start();
        }
        return watchdog;
    }

    void stop() {
        stopped.countDown();
    }

    private void watch(long periodNanos) {
        try {
            do {
                if (stopped.await(periodNanos, TimeUnit.NANOSECONDS)) {
                    return;
                }
            } while (!isRunaway(heartbeat.read()));
        } catch (InterruptedException e) {
            // Nobody interrupts this thread but a host that shuts down.
            Thread.currentThread().interrupt();
            return;
        }
        onRunaway.run();
    }

    /** Takes the result of one look at the heart. */
    boolean isRunaway(long reading) {
        stale = reading == last && !Heartbeat.inHost(reading) ? stale + 1 : 0;
        last = reading;
        return stale >= LOOKS;
    }
}
