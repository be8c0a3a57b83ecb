package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RunnableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** {@code java.util.concurrent.FutureTask} on virtual monitors. */
public class FutureTask<V> implements RunnableFuture<V> {
    private enum State {
        PENDING, NORMAL, FAILED, CANCELLED
    }

    private final Object monitor = new Object();
    private final Callable<V> callable;
    // Guarded by the monitor:
    private State state = State.PENDING;
    private V result;
    private Throwable failure;
    private Thread runner;

    /** Creates a task that calls {@code callable}. */
    public FutureTask(Callable<V> callable) {
        this.callable = Objects.requireNonNull(callable);
    }

    /** Creates a task that runs {@code runnable} and has that result. */
    public FutureTask(Runnable runnable, V result) {
        this(Executors.callable(runnable, result));
    }

    @Override
    public boolean isCancelled() {
        return state() == State.CANCELLED;
    }

    @Override
    public boolean isDone() {
        return state() != State.PENDING;
    }

    private State state() {
        synchronized (monitor) {
            return state;
        }
    }

    @Override
    public boolean cancel(boolean mayInterruptIfRunning) {
        synchronized (monitor) {
            if (!finish(State.CANCELLED)) {
                return false;
            }
            if (mayInterruptIfRunning && runner != null) {
                runner.interrupt();
            }
        }
        done();
        return true;
    }

    @Override
    public V get() throws InterruptedException, ExecutionException {
        try {
            return get(Deadline.NEVER);
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public V get(long timeout, TimeUnit unit) throws InterruptedException, ExecutionException, TimeoutException {
        return get(Deadline.after(timeout, unit));
    }

    private V get(Deadline deadline) throws InterruptedException, ExecutionException, TimeoutException {
        synchronized (monitor) {
            while (state == State.PENDING) {
                if (Thread.interrupted()) {
                    throw new InterruptedException();
                }
                if (!deadline.await(monitor)) {
                    throw new TimeoutException();
                }
            }
            if (state == State.CANCELLED) {
                throw new CancellationException();
            }
            if (state == State.FAILED) {
                throw new ExecutionException(failure);
            }
            return result;
        }
    }

    /** Called once when the task is done or cancelled; does nothing. */
    protected void done() {
    }

    /** Completes the task with a result unless it is done. */
    protected void set(V v) {
        synchronized (monitor) {
            if (!finish(State.NORMAL)) {
                return;
            }
            result = v;
        }
        done();
    }

    /** Completes the task with a failure unless it is done. */
    protected void setException(Throwable t) {
        synchronized (monitor) {
            if (!finish(State.FAILED)) {
                return;
            }
            failure = t;
        }
        done();
    }

    private boolean finish(State end) {
        if (state != State.PENDING) {
            return false;
        }
        state = end;
        monitor.notifyAll();
        return true;
    }

    @Override
    public void run() {
        if (!start()) {
            return;
        }
        try {
            set(callable.call());
        } catch (Throwable t) {
            setException(t);
        } finally {
            stop();
        }
    }

    /** Runs without setting a result, so that the task can run again; false if it failed, was cancelled or is done. */
    protected boolean runAndReset() {
        if (!start()) {
            return false;
        }
        try {
            callable.call();
            return state() == State.PENDING;
        } catch (Throwable t) {
            setException(t);
            return false;
        } finally {
            stop();
        }
    }

    private boolean start() {
        synchronized (monitor) {
            if (state != State.PENDING || runner != null) {
                return false;
            }
            runner = Thread.currentThread();
            return true;
        }
    }

    private void stop() {
        synchronized (monitor) {
            runner = null;
        }
    }

    @Override
    public String toString() {
        switch (state()) {
            case NORMAL:
                return super.toString() + "[Completed normally]";
            case FAILED:
                return super.toString() + "[Completed exceptionally: " + failure + "]";
            case CANCELLED:
                return super.toString() + "[Cancelled]";
            default:
                return super.toString() + "[Not completed, task = " + callable + "]";
        }
    }
}
