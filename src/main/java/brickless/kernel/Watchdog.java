package brickless.kernel;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Ends a run whose program does not enter the kernel for a long time, which only code that is not rewritten (the
 * JDK's) can do: by looping, or by waiting for something that never comes.
 *
 * <p>Patience is counted in processor time, which a loop uses up, and in looks at a thread that waits. So neither a
 * machine that slept nor one that is too busy to let the program run makes a runaway of it.
 */
final class Watchdog {
    static final int LOOKS = 10;
    /** In looks: for a thread that seems to run but uses no time, as one that waits for the network. */
    static final int LONGEST_SILENCE = 10 * LOOKS;

    private final Heartbeat heartbeat;
    private final long patienceNanos;
    private final Supplier<HostActivity> activity;
    private final Runnable onRunaway;
    private final CountDownLatch stopped = new CountDownLatch(1);

    /** Owned by the watching thread. */
    private long lastBeat = -1;
    private long busyNanosAtBeat;
    private int silentLooks;
    private int waitingLooks;

    Watchdog(Heartbeat heartbeat, long patienceNanos, Supplier<HostActivity> activity, Runnable onRunaway) {
        this.heartbeat = heartbeat;
        this.patienceNanos = patienceNanos;
        this.activity = activity;
        this.onRunaway = onRunaway;
    }

    /**
     * Begins to watch, in a daemon thread; with a patience of 0 nobody watches.
     *
     * @param running the host thread that executes the program now, null if there is none
     */
    static Watchdog watch(Heartbeat heartbeat, long patienceNanos, Supplier<Thread> running, Runnable onRunaway) {
        Watchdog watchdog = new Watchdog(heartbeat, patienceNanos, () -> HostActivity.of(running.get()), onRunaway);
        if (patienceNanos > 0) {
            Thread thread = new Thread(watchdog::watch, "brickless watchdog");
            thread.setDaemon(true);
            thread.start();
        }
        return watchdog;
    }

    void stop() {
        stopped.countDown();
    }

    private void watch() {
        try {
            do {
                if (stopped.await(Math.max(1, patienceNanos / LOOKS), TimeUnit.NANOSECONDS)) {
                    return;
                }
            } while (!isRunaway());
        } catch (InterruptedException e) {
            // Nobody interrupts this thread but a host that shuts down.
            Thread.currentThread().interrupt();
            return;
        }
        onRunaway.run();
    }

    /** Looks at the heart once. */
    boolean isRunaway() {
        long beat = heartbeat.read();
        HostActivity now = activity.get();
        if (beat != lastBeat || Heartbeat.inHost(beat)) {
            lastBeat = beat;
            busyNanosAtBeat = now.busyNanos();
            silentLooks = 0;
            waitingLooks = 0;
            return false;
        }
        silentLooks++;
        waitingLooks = now.waiting() ? waitingLooks + 1 : 0;
        return now.busyNanos() - busyNanosAtBeat >= patienceNanos || waitingLooks >= LOOKS
                || silentLooks >= LONGEST_SILENCE;
    }
}
