package brickless.device.panel;

import java.util.Arrays;

/** Keeps account of the keys that the program asks for again and again, without waiting for them. */
final class KeyQuestions {
    /**
     * Longest pause between two looks that still counts as asking on: loops that show a value each second. Assumption.
     */
    static final long BRIDGED_PAUSE_NANOS = 1_500_000_000;

    private static final int KEYS = 6;
    private static final long NEVER = Long.MIN_VALUE / 2;

    private final long[] sinceNanos = new long[KEYS];
    private final long[] lastNanos = new long[KEYS];

    KeyQuestions() {
        Arrays.fill(lastNanos, NEVER);
    }

    /** The program looks at keys. */
    synchronized void ask(int keyMask, long nowNanos) {
        for (int key = 0; key < KEYS; key++) {
            if ((keyMask & 1 << key) != 0) {
                if (nowNanos - lastNanos[key] > BRIDGED_PAUSE_NANOS) {
                    sinceNanos[key] = nowNanos;
                }
                lastNanos[key] = nowNanos;
            }
        }
    }

    /** Begins all counts anew because a key has moved. */
    synchronized void restart(long nowNanos) {
        Arrays.fill(sinceNanos, nowNanos);
    }

    /** Keys for which the program has been asking for at least that long, and still is. */
    synchronized int askedFor(long nanos, long nowNanos) {
        int keys = 0;
        for (int key = 0; key < KEYS; key++) {
            boolean still = nowNanos - lastNanos[key] <= BRIDGED_PAUSE_NANOS;
            keys |= still && nowNanos - sinceNanos[key] >= nanos ? 1 << key : 0;
        }
        return keys;
    }

    /** Whether the program has looked at one of the keys after that time. */
    synchronized boolean askedAfter(int keyMask, long nanos) {
        for (int key = 0; key < KEYS; key++) {
            if ((keyMask & 1 << key) != 0 && lastNanos[key] > nanos) {
                return true;
            }
        }
        return false;
    }
}
