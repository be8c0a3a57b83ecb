package brickless.concurrent.locks;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicReference;

/** A thread that a test brings to the point where it waits. */
public final class Waiting {
    private static final long PATIENCE_MILLIS = 20_000;

    private final AtomicReference<Throwable> thrown = new AtomicReference<>();
    private final Thread thread;

    /** Something that may throw. */
    public interface Action {
        /** Does it. */
        void run() throws Exception;
    }

    private Waiting(Action action) {
        thread = new Thread(() -> {
            try {
                action.run();
            } catch (Throwable t) {
                thrown.set(t);
            }
        });
        thread.setDaemon(true);
    }

    /** Starts a thread and returns at once. */
    public static Waiting started(Action action) {
        Waiting waiting = new Waiting(action);
        waiting.thread.start();
        return waiting;
    }

    /** Starts a thread and returns when it waits. */
    public static Waiting in(Action action) {
        Waiting waiting = started(action);
        while (!waiting.blocked()) {
            assertThat(waiting.thread.isAlive()).as("thread is expected to wait, but ended: " + waiting.thrown.get())
                    .isTrue();
            Thread.onSpinWait();
        }
        return waiting;
    }

    private boolean blocked() {
        Thread.State state = thread.getState();
        return state == Thread.State.WAITING || state == Thread.State.TIMED_WAITING;
    }

    /** The thread. */
    public Thread thread() {
        return thread;
    }

    /** Interrupts the thread. */
    public Waiting interrupted() {
        thread.interrupt();
        return this;
    }

    /** Waits for the end of the thread, which must come normally. */
    public void ends() throws InterruptedException {
        assertThat(outcome()).isNull();
    }

    /** Waits for the end of the thread and returns what it threw. */
    public Throwable outcome() throws InterruptedException {
        thread.join(PATIENCE_MILLIS);
        assertThat(thread.isAlive()).as("thread still waits").isFalse();
        return thrown.get();
    }
}
