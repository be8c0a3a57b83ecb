package brickless.concurrent;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.Delayed;
import java.util.concurrent.Future;
import java.util.concurrent.RunnableScheduledFuture;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/** {@code java.util.concurrent.ScheduledThreadPoolExecutor} on virtual threads and monitors. */
public class ScheduledThreadPoolExecutor extends ThreadPoolExecutor implements ScheduledExecutorService {
    private static final long KEEP_ALIVE_MILLIS = 10;

    private final AtomicLong sequence = new AtomicLong();
    private volatile boolean periodicAfterShutdown;
    private volatile boolean delayedAfterShutdown = true;
    private volatile boolean removeOnCancel;

    /** Creates a pool with default thread factory and {@link AbortPolicy}. */
    public ScheduledThreadPoolExecutor(int corePoolSize) {
        this(corePoolSize, Executors.defaultThreadFactory());
    }

    /** Creates a pool with {@link AbortPolicy}. */
    public ScheduledThreadPoolExecutor(int corePoolSize, ThreadFactory threadFactory) {
        this(corePoolSize, threadFactory, new AbortPolicy());
    }

    /** Creates a pool with default thread factory. */
    public ScheduledThreadPoolExecutor(int corePoolSize, RejectedExecutionHandler handler) {
        this(corePoolSize, Executors.defaultThreadFactory(), handler);
    }

    /** Creates a pool. */
    public ScheduledThreadPoolExecutor(int corePoolSize, ThreadFactory threadFactory,
            RejectedExecutionHandler handler) {
        super(corePoolSize, Integer.MAX_VALUE, KEEP_ALIVE_MILLIS, TimeUnit.MILLISECONDS, new DelayedWorkQueue(),
                threadFactory, handler);
    }

    /** Waiting tasks, the one that is due next first. */
    private static final class DelayedWorkQueue extends GuardedQueue<Runnable> {
        DelayedWorkQueue() {
            super(new PriorityQueue<>(Comparator.comparing(Delayed.class::cast)), Integer.MAX_VALUE);
        }

        @Override
        long nanosUntilReady(Runnable head) {
            return ((Delayed) head).getDelay(TimeUnit.NANOSECONDS);
        }
    }

    /** A task with the time at which it is due. */
    private final class ScheduledTask<V> extends FutureTask<V> implements RunnableScheduledFuture<V> {
        private final long number = sequence.getAndIncrement();
        /** Positive: fixed rate; negative: fixed delay; 0: once. */
        private final long periodNanos;
        private volatile long dueNanos;
        /** What is queued for this task: itself or what {@link #decorateTask} made of it. */
        private RunnableScheduledFuture<V> outer = this;

        ScheduledTask(Callable<V> callable, long dueNanos, long periodNanos) {
            super(callable);
            this.dueNanos = dueNanos;
            this.periodNanos = periodNanos;
        }

        @Override
        public long getDelay(TimeUnit unit) {
            return unit.convert(dueNanos - System.nanoTime(), TimeUnit.NANOSECONDS);
        }

        @Override
        public int compareTo(Delayed other) {
            if (other == this) {
                return 0;
            }
            if (other instanceof ScheduledTask) {
                ScheduledTask<?> task = (ScheduledTask<?>) other;
                long difference = dueNanos - task.dueNanos;
                return difference == 0 ? Long.compare(number, task.number) : Long.signum(difference);
            }
            return Long.compare(getDelay(TimeUnit.NANOSECONDS), other.getDelay(TimeUnit.NANOSECONDS));
        }

        @Override
        public boolean isPeriodic() {
            return periodNanos != 0;
        }

        @Override
        public boolean cancel(boolean mayInterruptIfRunning) {
            boolean cancelled = super.cancel(mayInterruptIfRunning);
            if (cancelled && removeOnCancel) {
                remove(outer);
            }
            return cancelled;
        }

        @Override
        public void run() {
            if (!mayRun(this)) {
                cancel(false);
            } else if (!isPeriodic()) {
                super.run();
            } else if (runAndReset()) {
                dueNanos = periodNanos > 0 ? dueNanos + periodNanos : dueAfter(-periodNanos);
                queueAgain(outer);
            }
        }
    }

    private static long dueAfter(long delayNanos) {
        return System.nanoTime() + Math.min(Math.max(delayNanos, 0), Long.MAX_VALUE / 2);
    }

    private boolean mayRun(RunnableScheduledFuture<?> task) {
        if (!isShutdown()) {
            return true;
        }
        return !isStopped() && runsAfterShutdown(task);
    }

    private boolean runsAfterShutdown(RunnableScheduledFuture<?> task) {
        return task.isPeriodic() ? periodicAfterShutdown : delayedAfterShutdown
                || task.getDelay(TimeUnit.NANOSECONDS) <= 0;
    }

    private void queue(RunnableScheduledFuture<?> task) {
        if (isShutdown()) {
            reject(task);
            return;
        }
        getQueue().add(task);
        cancelOrEnsureWorker(task);
    }

    private void queueAgain(RunnableScheduledFuture<?> task) {
        if (mayRun(task)) {
            getQueue().add(task);
            cancelOrEnsureWorker(task);
        } else {
            task.cancel(false);
        }
    }

    private void cancelOrEnsureWorker(RunnableScheduledFuture<?> task) {
        if (!mayRun(task) && remove(task)) {
            task.cancel(false);
        } else {
            ensureWorker();
        }
    }

    @Override
    void onShutdown() {
        for (Object queued : getQueue().toArray()) {
            RunnableScheduledFuture<?> task = (RunnableScheduledFuture<?>) queued;
            if (task.isCancelled() || !runsAfterShutdown(task)) {
                getQueue().remove(task);
                task.cancel(false);
            }
        }
    }

    /** Lets subclasses replace the future of a runnable; returns it as it is. */
    protected <V> RunnableScheduledFuture<V> decorateTask(Runnable runnable, RunnableScheduledFuture<V> task) {
        return task;
    }

    /** Lets subclasses replace the future of a callable; returns it as it is. */
    protected <V> RunnableScheduledFuture<V> decorateTask(Callable<V> callable, RunnableScheduledFuture<V> task) {
        return task;
    }

    @Override
    public ScheduledFuture<?> schedule(Runnable command, long delay, TimeUnit unit) {
        return schedule(command, null, unit.toNanos(delay), 0);
    }

    @Override
    public <V> ScheduledFuture<V> schedule(Callable<V> callable, long delay, TimeUnit unit) {
        Objects.requireNonNull(callable);
        ScheduledTask<V> task = new ScheduledTask<>(callable, dueAfter(unit.toNanos(delay)), 0);
        task.outer = decorateTask(callable, task);
        queue(task.outer);
        return task.outer;
    }

    @Override
    public ScheduledFuture<?> scheduleAtFixedRate(Runnable command, long initialDelay, long period, TimeUnit unit) {
        requirePositive(period);
        return schedule(command, null, unit.toNanos(initialDelay), unit.toNanos(period));
    }

    @Override
    public ScheduledFuture<?> scheduleWithFixedDelay(Runnable command, long initialDelay, long delay, TimeUnit unit) {
        requirePositive(delay);
        return schedule(command, null, unit.toNanos(initialDelay), -unit.toNanos(delay));
    }

    private static void requirePositive(long nanos) {
        if (nanos <= 0) {
            throw new IllegalArgumentException();
        }
    }

    private <V> RunnableScheduledFuture<V> schedule(Runnable command, V result, long delayNanos, long periodNanos) {
        ScheduledTask<V> task =
                new ScheduledTask<>(Executors.callable(command, result), dueAfter(delayNanos), periodNanos);
        task.outer = decorateTask(command, task);
        queue(task.outer);
        return task.outer;
    }

    @Override
    public void execute(Runnable command) {
        schedule(command, 0, TimeUnit.NANOSECONDS);
    }

    @Override
    public Future<?> submit(Runnable task) {
        return schedule(task, 0, TimeUnit.NANOSECONDS);
    }

    @Override
    public <T> Future<T> submit(Runnable task, T result) {
        return schedule(task, result, 0, 0);
    }

    @Override
    public <T> Future<T> submit(Callable<T> task) {
        return schedule(task, 0, TimeUnit.NANOSECONDS);
    }

    /** Sets whether periodic tasks go on after {@link #shutdown}; by default not. */
    public void setContinueExistingPeriodicTasksAfterShutdownPolicy(boolean value) {
        periodicAfterShutdown = value;
        if (!value && isShutdown()) {
            shutdown();
        }
    }

    /** Whether periodic tasks go on after {@link #shutdown}. */
    public boolean getContinueExistingPeriodicTasksAfterShutdownPolicy() {
        return periodicAfterShutdown;
    }

    /** Sets whether delayed tasks still run after {@link #shutdown}; by default they do. */
    public void setExecuteExistingDelayedTasksAfterShutdownPolicy(boolean value) {
        delayedAfterShutdown = value;
        if (!value && isShutdown()) {
            shutdown();
        }
    }

    /** Whether delayed tasks still run after {@link #shutdown}. */
    public boolean getExecuteExistingDelayedTasksAfterShutdownPolicy() {
        return delayedAfterShutdown;
    }

    /** Sets whether cancelled tasks leave the queue at once; by default not. */
    public void setRemoveOnCancelPolicy(boolean value) {
        removeOnCancel = value;
    }

    /** Whether cancelled tasks leave the queue at once. */
    public boolean getRemoveOnCancelPolicy() {
        return removeOnCancel;
    }

    @Override
    public void shutdown() {
        super.shutdown();
    }

    @Override
    public List<Runnable> shutdownNow() {
        return super.shutdownNow();
    }

    @Override
    public BlockingQueue<Runnable> getQueue() {
        return super.getQueue();
    }
}
