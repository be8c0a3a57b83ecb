package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.KeySocket;

/** The moments at which one wait looks at the keys: its start, and every 50 ms after. Used by one thread. */
final class KeyPolls {
    /** Time between two looks in milliseconds. */
    static final int PERIOD_MILLIS = 50;

    private static final long NANOS_PER_MILLI = 1_000_000;
    private static final long PERIOD_NANOS = PERIOD_MILLIS * NANOS_PER_MILLI;

    private final KeySocket socket = BrickAccess.brick().keys();
    private final boolean listening;
    private final long timeoutNanos;
    private final long startNanos = System.nanoTime();

    private KeyPolls(int timeoutMillis, boolean listening) {
        this.timeoutNanos = timeoutMillis * NANOS_PER_MILLI;
        this.listening = listening;
    }

    /** A wait of the program; a limit of 0 ms is none. */
    static KeyPolls forProgram(int timeoutMillis) {
        return new KeyPolls(timeoutMillis, false);
    }

    /** A wait without limit on behalf of listeners. */
    static KeyPolls forListeners() {
        return new KeyPolls(0, true);
    }

    /**
     * Blocks until the first look at which the keys may differ from {@code state}.
     *
     * @return false if the time limit is over at that moment, or the thread is interrupted (which stays marked)
     */
    boolean awaitNext(int state) {
        try {
            if (timeoutNanos != 0) {
                return awaitWithin(state, lastPollNanos() - System.nanoTime());
            }
            if (listening) {
                socket.awaitListenerEvent(state);
            } else {
                socket.awaitChange(state, 0);
            }
            sleepUntilPoll();
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private boolean awaitWithin(int state, long nanosLeft) throws InterruptedException {
        if (nanosLeft <= 0) {
            return false;
        }
        if (socket.awaitChange(state, nanosLeft) == state) {
            return false;
        }
        sleepUntilPoll();
        return System.nanoTime() < lastPollNanos();
    }

    /** The first multiple of the period, at least one, that reaches the time limit. */
    private long lastPollNanos() {
        long periods = Math.max(1, (timeoutNanos + PERIOD_NANOS - 1) / PERIOD_NANOS);
        return startNanos + periods * PERIOD_NANOS;
    }

    private void sleepUntilPoll() throws InterruptedException {
        long sinceStart = System.nanoTime() - startNanos;
        long nextPoll = startNanos + Math.max(1, (sinceStart + PERIOD_NANOS - 1) / PERIOD_NANOS) * PERIOD_NANOS;
        long nanos = nextPoll - System.nanoTime();
        if (nanos > 0) {
            Thread.sleep(nanos / NANOS_PER_MILLI, (int) (nanos % NANOS_PER_MILLI));
        }
    }
}
