package brickless.concurrent.util;

/** {@code java.util.TimerTask}: what a {@link Timer} runs. */
public abstract class TimerTask implements Runnable {
    private enum State {
        NEW, SCHEDULED, RAN, CANCELLED
    }

    // Guarded by the task:
    private State state = State.NEW;
    private long due;
    private long lastDue;
    /** Positive: fixed rate; negative: fixed delay; 0: once. */
    private long period;

    /** Creates a task. */
    protected TimerTask() {
    }

    /** What the task does. */
    @Override
    public abstract void run();

    /** Prevents further runs; true if that prevented at least one. */
    public boolean cancel() {
        synchronized (this) {
            boolean prevented = state == State.SCHEDULED;
            state = State.CANCELLED;
            return prevented;
        }
    }

    /** When the latest run was due, in milliseconds since 1970; while the task runs, this run. */
    public long scheduledExecutionTime() {
        synchronized (this) {
            return lastDue;
        }
    }

    /** Called once by the timer. */
    final void schedule(long dueMillis, long periodMillis) {
        synchronized (this) {
            if (state != State.NEW) {
                throw new IllegalStateException("Task already scheduled or cancelled");
            }
            state = State.SCHEDULED;
            due = dueMillis;
            period = periodMillis;
        }
    }

    final long due() {
        synchronized (this) {
            return due;
        }
    }

    final boolean cancelled() {
        synchronized (this) {
            return state == State.CANCELLED;
        }
    }

    /**
     * Called by the timer before a run; plans the next one. False if there is none to plan or the task was cancelled.
     */
    final boolean advance(long nowMillis) {
        synchronized (this) {
            lastDue = due;
            if (state == State.SCHEDULED && period == 0) {
                state = State.RAN;
            }
            due = period > 0 ? due + period : nowMillis - period;
            return state == State.SCHEDULED;
        }
    }
}
