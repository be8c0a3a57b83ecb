package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.RunnableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;

/**
 * {@code java.util.concurrent.ForkJoinPool}, simplified: daemon workers with one common queue instead of work stealing,
 * which a brick with one processor would not profit from. Arguments that tune stealing are accepted and ignored.
 */
public class ForkJoinPool extends AbstractExecutorService {
    /** Processors of the brick. */
    static final int PROCESSORS = 1;
    /** Makes plain {@link ForkJoinWorkerThread}s. */
    public static final ForkJoinWorkerThreadFactory defaultForkJoinWorkerThreadFactory =
            pool -> new ForkJoinWorkerThread(pool) { };

    private static final int MAX_PARALLELISM = 32767;
    private static final long KEEP_ALIVE_SECONDS = 60;
    private static final AtomicInteger POOLS = new AtomicInteger();

    private final ForkJoinWorkerThreadFactory factory;
    private final Thread.UncaughtExceptionHandler handler;
    private final boolean asyncMode;
    private final String namePrefix;
    private final LinkedBlockingDeque<Runnable> queue = new LinkedBlockingDeque<>();
    private final ThreadPoolExecutor workers;
    private final AtomicInteger threads = new AtomicInteger();

    /** Makes the workers of a pool. */
    public interface ForkJoinWorkerThreadFactory {
        /** A new worker, not started; null refuses. */
        ForkJoinWorkerThread newThread(ForkJoinPool pool);
    }

    /** Something that a task may have to wait for. */
    public interface ManagedBlocker {
        /** Waits; true if no more waiting is needed. */
        boolean block() throws InterruptedException;

        /** Whether no waiting is needed. */
        boolean isReleasable();
    }

    /** A queued task. */
    private static final class Entry implements Runnable {
        private final ForkJoinTask<?> task;

        Entry(ForkJoinTask<?> task) {
            this.task = task;
        }

        @Override
        public void run() {
            task.begin();
        }
    }

    private static final class Common {
        static final ForkJoinPool POOL =
                new ForkJoinPool(PROCESSORS, defaultForkJoinWorkerThreadFactory, null, false,
                        "ForkJoinPool.commonPool-worker-");
    }

    /** Creates a pool as wide as the brick: one processor. */
    public ForkJoinPool() {
        this(PROCESSORS);
    }

    /** Creates a pool of at most {@code parallelism} workers. */
    public ForkJoinPool(int parallelism) {
        this(parallelism, defaultForkJoinWorkerThreadFactory, null, false);
    }

    /** Creates a pool; {@code handler} (may be null) is told what ends a worker. */
    public ForkJoinPool(int parallelism, ForkJoinWorkerThreadFactory factory, Thread.UncaughtExceptionHandler handler,
            boolean asyncMode) {
        this(parallelism, factory, handler, asyncMode, "ForkJoinPool-" + POOLS.incrementAndGet() + "-worker-");
    }

    /** Creates a pool; what tunes the number of workers beyond {@code parallelism} is ignored. */
    public ForkJoinPool(int parallelism, ForkJoinWorkerThreadFactory factory, Thread.UncaughtExceptionHandler handler,
            boolean asyncMode, int corePoolSize, int maximumPoolSize, int minimumRunnable,
            Predicate<? super ForkJoinPool> saturate, long keepAliveTime, TimeUnit unit) {
        this(parallelism, factory, handler, asyncMode);
        Objects.requireNonNull(unit);
    }

    private ForkJoinPool(int parallelism, ForkJoinWorkerThreadFactory factory, Thread.UncaughtExceptionHandler handler,
            boolean asyncMode, String namePrefix) {
        if (parallelism <= 0 || parallelism > MAX_PARALLELISM) {
            throw new IllegalArgumentException();
        }
        this.factory = Objects.requireNonNull(factory);
        this.handler = handler;
        this.asyncMode = asyncMode;
        this.namePrefix = namePrefix;
        this.workers = new ThreadPoolExecutor(parallelism, parallelism, KEEP_ALIVE_SECONDS, TimeUnit.SECONDS, queue,
                this::newThread);
        this.workers.allowCoreThreadTimeOut(true);
    }

    private Thread newThread(Runnable work) {
        ForkJoinWorkerThread thread = factory.newThread(this);
        if (thread != null) {
            thread.assign(threads.incrementAndGet(), work);
            if (handler != null) {
                thread.setUncaughtExceptionHandler(handler);
            }
        }
        return thread;
    }

    /** The pool that tasks use which are not told another one; cannot be shut down. */
    public static ForkJoinPool commonPool() {
        return Common.POOL;
    }

    final String namePrefix() {
        return namePrefix;
    }

    final void push(ForkJoinTask<?> task) {
        workers.execute(new Entry(Objects.requireNonNull(task)));
    }

    final boolean unpush(ForkJoinTask<?> task) {
        return queue.removeIf(entry -> ((Entry) entry).task == task);
    }

    final ForkJoinTask<?> peekTask() {
        Entry entry = (Entry) queue.peek();
        return entry == null ? null : entry.task;
    }

    final void helpQuiesce() {
        ForkJoinTask<?> task;
        while ((task = pollSubmission()) != null) {
            task.begin();
        }
    }

    /** Runs the task in the pool and returns its result; rethrows what it threw. */
    public <T> T invoke(ForkJoinTask<T> task) {
        push(task);
        return task.join();
    }

    /** Runs the task in the pool. */
    public void execute(ForkJoinTask<?> task) {
        push(task);
    }

    @Override
    public void execute(Runnable task) {
        submit(task);
    }

    /** Runs the task in the pool and returns it. */
    public <T> ForkJoinTask<T> submit(ForkJoinTask<T> task) {
        push(task);
        return task;
    }

    @Override
    public <T> ForkJoinTask<T> submit(Callable<T> task) {
        return submit(ForkJoinTask.adapt(task));
    }

    @Override
    public <T> ForkJoinTask<T> submit(Runnable task, T result) {
        return submit(ForkJoinTask.adapt(task, result));
    }

    @Override
    public ForkJoinTask<?> submit(Runnable task) {
        ForkJoinTask<?> forkable = task instanceof ForkJoinTask<?> ? (ForkJoinTask<?>) task : ForkJoinTask.adapt(task);
        push(forkable);
        return forkable;
    }

    @Override
    protected <T> RunnableFuture<T> newTaskFor(Runnable runnable, T value) {
        return new AdaptedTask<>(Executors.callable(runnable, value));
    }

    @Override
    protected <T> RunnableFuture<T> newTaskFor(Callable<T> callable) {
        return new AdaptedTask<>(callable);
    }

    /** What makes the workers. */
    public ForkJoinWorkerThreadFactory getFactory() {
        return factory;
    }

    /** Who is told what ends a worker, or null. */
    public Thread.UncaughtExceptionHandler getUncaughtExceptionHandler() {
        return handler;
    }

    /** Largest number of workers. */
    public int getParallelism() {
        return workers.getCorePoolSize();
    }

    /** Largest number of workers of the common pool. */
    public static int getCommonPoolParallelism() {
        return PROCESSORS;
    }

    /** Number of workers. */
    public int getPoolSize() {
        return workers.getPoolSize();
    }

    /** The argument of the constructor; tasks always run in the order in which they came. */
    public boolean getAsyncMode() {
        return asyncMode;
    }

    /** Number of workers that run a task. */
    public int getRunningThreadCount() {
        return workers.getActiveCount();
    }

    /** Number of workers that run a task. */
    public int getActiveThreadCount() {
        return workers.getActiveCount();
    }

    /** Whether no task is waiting or running. */
    public boolean isQuiescent() {
        return queue.isEmpty() && workers.getActiveCount() == 0;
    }

    /** Always 0: nothing is stolen. */
    public long getStealCount() {
        return 0;
    }

    /** Number of waiting tasks. */
    public long getQueuedTaskCount() {
        return queue.size();
    }

    /** Number of waiting tasks. */
    public int getQueuedSubmissionCount() {
        return queue.size();
    }

    /** Whether tasks are waiting. */
    public boolean hasQueuedSubmissions() {
        return !queue.isEmpty();
    }

    /** Takes a waiting task, or null. */
    protected ForkJoinTask<?> pollSubmission() {
        Entry entry = (Entry) queue.poll();
        return entry == null ? null : entry.task;
    }

    /** Moves the waiting tasks to a collection and returns their number. */
    protected int drainTasksTo(Collection<? super ForkJoinTask<?>> c) {
        int drained = 0;
        ForkJoinTask<?> task;
        while ((task = pollSubmission()) != null) {
            c.add(task);
            drained++;
        }
        return drained;
    }

    @Override
    public String toString() {
        return super.toString() + "[parallelism = " + getParallelism() + ", size = " + getPoolSize() + ", active = "
                + getActiveThreadCount() + ", submissions = " + getQueuedSubmissionCount() + "]";
    }

    private boolean isCommon() {
        return this == Common.POOL;
    }

    @Override
    public void shutdown() {
        if (!isCommon()) {
            workers.shutdown();
        }
    }

    @Override
    public List<Runnable> shutdownNow() {
        if (!isCommon()) {
            for (Runnable entry : workers.shutdownNow()) {
                ((Entry) entry).task.cancel(false);
            }
        }
        return List.of();
    }

    @Override
    public boolean isTerminated() {
        return workers.isTerminated();
    }

    /** Whether a shutdown has begun but not ended. */
    public boolean isTerminating() {
        return workers.isTerminating();
    }

    @Override
    public boolean isShutdown() {
        return workers.isShutdown();
    }

    @Override
    public boolean awaitTermination(long timeout, TimeUnit unit) throws InterruptedException {
        if (isCommon()) {
            awaitQuiescence(timeout, unit);
            return false;
        }
        return workers.awaitTermination(timeout, unit);
    }

    /**
     * Waits until no task is waiting or running; false if the time passed first. A worker of the pool helps instead.
     */
    public boolean awaitQuiescence(long timeout, TimeUnit unit) {
        if (ForkJoinTask.getPool() == this) {
            helpQuiesce();
            return true;
        }
        return workers.awaitIdle(Deadline.after(timeout, unit));
    }

    /** Waits for {@code blocker}. */
    public static void managedBlock(ManagedBlocker blocker) throws InterruptedException {
        boolean released = false;
        while (!released) {
            released = blocker.isReleasable() || blocker.block();
        }
    }
}
