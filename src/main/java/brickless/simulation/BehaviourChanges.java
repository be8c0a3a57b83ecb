package brickless.simulation;

/**
 * Which behaviour an arbitrator wants or runs, as it is worth writing down. Many programs' actions return at once and
 * are started again hundreds of times a second; the moments in between, when none is active, are left out. Used by one
 * thread at a time.
 */
final class BehaviourChanges {
    /** None for so long is none. */
    private static final long SETTLED_NANOS = 20_000_000;
    private static final int NONE = -1;

    /** Told what to write down. */
    interface Listener {
        void changed(long timeNanos, int behaviour);
    }

    private final Listener listener;
    private int written = NONE;
    private int current = NONE;
    private long since;
    private boolean endMatters;

    BehaviourChanges(Listener listener) {
        this.listener = listener;
    }

    /** The present behaviour, −1 for none. */
    int current() {
        return current;
    }

    void set(long nowNanos, int behaviour) {
        if (behaviour != current) {
            since = nowNanos;
        }
        current = behaviour;
        if (behaviour != NONE || endMatters) {
            endMatters = false;
            write(nowNanos);
        }
    }

    /**
     * The present behaviour was told to end: when it does is written down, however short the time until the next one.
     */
    void awaitEnd() {
        endMatters = current != NONE;
    }

    /** Whether time alone can change what is written. */
    boolean unsettled() {
        return current == NONE && written != NONE;
    }

    /** To be called as time passes. */
    void step(long nowNanos) {
        if (current == NONE && nowNanos - since >= SETTLED_NANOS) {
            write(nowNanos);
        }
    }

    private void write(long nowNanos) {
        if (current != written) {
            written = current;
            listener.changed(nowNanos, current);
        }
    }
}
