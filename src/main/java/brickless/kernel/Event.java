package brickless.kernel;

/** Something that happens at a virtual time; kept by its owner and put into an {@link EventQueue} again and again. */
final class Event {
    private final Runnable action;
    /** Guarded by the queue that holds the event. */
    long timeNanos;
    long sequence;
    int index = -1;

    Event(Runnable action) {
        this.action = action;
    }

    boolean queued() {
        return index >= 0;
    }

    void run() {
        action.run();
    }

    boolean before(Event other) {
        return timeNanos != other.timeNanos ? timeNanos < other.timeNanos : sequence < other.sequence;
    }
}
