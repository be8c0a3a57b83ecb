package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * {@code java.util.concurrent.ForkJoinTask} on virtual monitors. A worker that joins a task which nobody has begun runs
 * it itself, so workers never wait for each other in a circle.
 */
public abstract class ForkJoinTask<V> implements Future<V> {
    private enum State {
        NEW, RUNNING, NORMAL, FAILED, CANCELLED
    }

    private final Object monitor = new Object();
    // Guarded by the monitor:
    private State state = State.NEW;
    private Throwable failure;
    private short tag;

    /** Creates the task. */
    public ForkJoinTask() {
    }

    /** The result, or null before there is one. */
    public abstract V getRawResult();

    /** Stores the result. */
    protected abstract void setRawResult(V value);

    /** Does the work; true if the task is complete then. */
    protected abstract boolean exec();

    /** Hands the task to the pool of the current worker, or to the common pool. */
    public final ForkJoinTask<V> fork() {
        ForkJoinPool pool = getPool();
        (pool == null ? ForkJoinPool.commonPool() : pool).push(this);
        return this;
    }

    /** Waits for the result; rethrows what the task threw. */
    public final V join() {
        quietlyJoin();
        return report();
    }

    /** Runs the task here unless somebody has begun it, and returns the result; rethrows what the task threw. */
    public final V invoke() {
        quietlyInvoke();
        return report();
    }

    /** Waits until the task is done. */
    public final void quietlyJoin() {
        if (inForkJoinPool()) {
            begin();
        }
        awaitDone();
    }

    /** Runs the task here unless somebody has begun it. */
    public final void quietlyInvoke() {
        begin();
        awaitDone();
    }

    /** Runs the task unless somebody has begun it. */
    final void begin() {
        synchronized (monitor) {
            if (state != State.NEW) {
                return;
            }
            state = State.RUNNING;
        }
        try {
            if (exec()) {
                quietlyComplete();
            }
        } catch (Throwable t) {
            finish(State.FAILED, t);
        }
    }

    private void awaitDone() {
        boolean interrupted = false;
        synchronized (monitor) {
            while (!isDone()) {
                try {
                    monitor.wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean finish(State end, Throwable cause) {
        synchronized (monitor) {
            if (isDone()) {
                return false;
            }
            state = end;
            failure = cause;
            monitor.notifyAll();
            return true;
        }
    }

    private V report() {
        Throwable thrown = getException();
        if (thrown instanceof Error) {
            throw (Error) thrown;
        }
        if (thrown instanceof RuntimeException) {
            throw (RuntimeException) thrown;
        }
        if (thrown != null) {
            throw new RuntimeException(thrown);
        }
        return getRawResult();
    }

    @Override
    public final V get() throws InterruptedException, ExecutionException {
        try {
            return get(Deadline.NEVER);
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public final V get(long timeout, TimeUnit unit) throws InterruptedException, ExecutionException, TimeoutException {
        return get(Deadline.after(timeout, unit));
    }

    private V get(Deadline deadline) throws InterruptedException, ExecutionException, TimeoutException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        if (inForkJoinPool()) {
            begin();
        }
        synchronized (monitor) {
            while (!isDone()) {
                if (!deadline.await(monitor)) {
                    throw new TimeoutException();
                }
            }
        }
        if (isCancelled()) {
            throw new CancellationException();
        }
        Throwable thrown = getException();
        if (thrown != null) {
            throw new ExecutionException(thrown);
        }
        return getRawResult();
    }

    /** Runs both tasks and waits for them; throws what one of them threw. */
    public static void invokeAll(ForkJoinTask<?> t1, ForkJoinTask<?> t2) {
        invokeAll(List.of(t1, t2));
    }

    /** Runs all tasks and waits for them; throws what one of them threw. */
    public static void invokeAll(ForkJoinTask<?>... tasks) {
        invokeAll(Arrays.asList(tasks));
    }

    /** Runs all tasks, the first one here, and waits for them; throws what one of them threw. */
    public static <T extends ForkJoinTask<?>> Collection<T> invokeAll(Collection<T> tasks) {
        ForkJoinTask<?> first = null;
        for (T task : tasks) {
            if (first == null) {
                first = task;
            } else {
                task.fork();
            }
        }
        if (first != null) {
            first.invoke();
            tasks.forEach(ForkJoinTask::join);
        }
        return tasks;
    }

    @Override
    public boolean cancel(boolean mayInterruptIfRunning) {
        finish(State.CANCELLED, null);
        return isCancelled();
    }

    @Override
    public final boolean isDone() {
        return state().compareTo(State.NORMAL) >= 0;
    }

    @Override
    public final boolean isCancelled() {
        return state() == State.CANCELLED;
    }

    private State state() {
        synchronized (monitor) {
            return state;
        }
    }

    /** Whether the task threw or was cancelled. */
    public final boolean isCompletedAbnormally() {
        return state().compareTo(State.FAILED) >= 0;
    }

    /** Whether the task is complete with a result. */
    public final boolean isCompletedNormally() {
        return state() == State.NORMAL;
    }

    /** What the task threw, a CancellationException if it was cancelled, else null. */
    public final Throwable getException() {
        synchronized (monitor) {
            return state == State.CANCELLED ? new CancellationException() : failure;
        }
    }

    /** Completes the task with a failure unless it is done. */
    public void completeExceptionally(Throwable ex) {
        boolean unchecked = ex instanceof RuntimeException || ex instanceof Error;
        finish(State.FAILED, unchecked ? ex : new RuntimeException(ex));
    }

    /** Completes the task with a result. */
    public void complete(V value) {
        try {
            setRawResult(value);
        } catch (Throwable t) {
            finish(State.FAILED, t);
            return;
        }
        quietlyComplete();
    }

    /** Completes the task with the result that it has. */
    public final void quietlyComplete() {
        finish(State.NORMAL, null);
    }

    /** Makes a task that is done ready to be run again. */
    public void reinitialize() {
        synchronized (monitor) {
            state = State.NEW;
            failure = null;
        }
    }

    /** Runs tasks of the current pool until none is waiting, then waits until none is running elsewhere. */
    public static void helpQuiesce() {
        ForkJoinPool pool = getPool();
        (pool == null ? ForkJoinPool.commonPool() : pool).helpQuiesce();
    }

    /** The pool of the current worker, or null. */
    public static ForkJoinPool getPool() {
        Thread thread = Thread.currentThread();
        return thread instanceof ForkJoinWorkerThread ? ((ForkJoinWorkerThread) thread).getPool() : null;
    }

    /** Whether the current thread is a worker. */
    public static boolean inForkJoinPool() {
        return getPool() != null;
    }

    /** Takes the task back from the pool if nobody has begun it. */
    public boolean tryUnfork() {
        ForkJoinPool pool = getPool();
        return (pool == null ? ForkJoinPool.commonPool() : pool).unpush(this);
    }

    /** Number of tasks that wait in the current pool. */
    public static int getQueuedTaskCount() {
        ForkJoinPool pool = getPool();
        return pool == null ? 0 : (int) pool.getQueuedTaskCount();
    }

    /** Number of tasks that wait in the current pool beyond the number of workers. */
    public static int getSurplusQueuedTaskCount() {
        ForkJoinPool pool = getPool();
        return pool == null ? 0 : getQueuedTaskCount() - pool.getParallelism() + 1;
    }

    /** A task that waits in the current pool, or null. */
    protected static ForkJoinTask<?> peekNextLocalTask() {
        ForkJoinPool pool = getPool();
        return pool == null ? null : pool.peekTask();
    }

    /** Takes a task that waits in the current pool, or null. */
    protected static ForkJoinTask<?> pollNextLocalTask() {
        return pollTask();
    }

    /** Takes a task that waits in the current pool, or null. */
    protected static ForkJoinTask<?> pollTask() {
        ForkJoinPool pool = getPool();
        return pool == null ? null : pool.pollSubmission();
    }

    /** Takes a task that waits in the current pool, or null. */
    protected static ForkJoinTask<?> pollSubmission() {
        return pollTask();
    }

    /** The tag. */
    public final short getForkJoinTaskTag() {
        synchronized (monitor) {
            return tag;
        }
    }

    /** Sets the tag and returns the previous one. */
    public final short setForkJoinTaskTag(short newValue) {
        synchronized (monitor) {
            short previous = tag;
            tag = newValue;
            return previous;
        }
    }

    /** Sets the tag if it has the expected value. */
    public final boolean compareAndSetForkJoinTaskTag(short expect, short update) {
        synchronized (monitor) {
            boolean expected = tag == expect;
            tag = expected ? update : tag;
            return expected;
        }
    }

    /** A task that runs {@code runnable}. */
    public static ForkJoinTask<?> adapt(Runnable runnable) {
        return adapt(runnable, null);
    }

    /** A task that runs {@code runnable} and has that result. */
    public static <T> ForkJoinTask<T> adapt(Runnable runnable, T result) {
        return new AdaptedTask<>(Executors.callable(runnable, result));
    }

    /** A task that calls {@code callable}; checked exceptions are wrapped. */
    public static <T> ForkJoinTask<T> adapt(Callable<? extends T> callable) {
        return new AdaptedTask<>(callable);
    }
}
