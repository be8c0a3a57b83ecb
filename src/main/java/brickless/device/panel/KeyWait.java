package brickless.device.panel;

import java.util.OptionalLong;

/** Keeps account of how long the program has been waiting for a key without doing anything else. */
final class KeyWait {
    /**
     * Longest pause between two waits that still counts as one wait. Shorter than any sensor read or drawing, longer
     * than the few clock reads of a loop around a wait with time-out. Assumption.
     */
    static final long BRIDGED_PAUSE_NANOS = 100_000;

    private int waiters;
    private long sinceNanos;
    private long endedNanos = Long.MIN_VALUE / 2;

    synchronized void begin(long nowNanos) {
        if (waiters == 0 && nowNanos - endedNanos > BRIDGED_PAUSE_NANOS) {
            sinceNanos = nowNanos;
        }
        waiters++;
    }

    synchronized void end(long nowNanos) {
        waiters--;
        endedNanos = nowNanos;
    }

    /** Begins the count anew because a key has moved. */
    synchronized void restart(long nowNanos) {
        sinceNanos = nowNanos;
        endedNanos = nowNanos;
    }

    /** No wait that goes on now or is yet to begin can have begun earlier than this. */
    synchronized long earliest(long nowNanos) {
        return waiters > 0 || nowNanos - endedNanos <= BRIDGED_PAUSE_NANOS ? sinceNanos : nowNanos;
    }

    synchronized OptionalLong since() {
        return waiters == 0 ? OptionalLong.empty() : OptionalLong.of(sinceNanos);
    }
}
