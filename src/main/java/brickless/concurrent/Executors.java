package brickless.concurrent;

import java.security.PrivilegedAction;
import java.security.PrivilegedExceptionAction;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * {@code java.util.concurrent.Executors}; pools are numbered per robot. There is no security manager, so "privileged"
 * changes nothing.
 */
public class Executors {
    private static final long CACHED_SECONDS = 60;

    private Executors() {
    }

    /** A pool of {@code nThreads} threads. */
    public static ExecutorService newFixedThreadPool(int nThreads) {
        return newFixedThreadPool(nThreads, defaultThreadFactory());
    }

    /** A pool of {@code nThreads} threads. */
    public static ExecutorService newFixedThreadPool(int nThreads, ThreadFactory threadFactory) {
        return new ThreadPoolExecutor(nThreads, nThreads, 0, TimeUnit.MILLISECONDS, new LinkedBlockingQueue<>(),
                threadFactory);
    }

    /** A pool as wide as the brick: one processor. */
    public static ExecutorService newWorkStealingPool() {
        return newWorkStealingPool(ForkJoinPool.PROCESSORS);
    }

    /** A pool of at most {@code parallelism} daemon threads. */
    public static ExecutorService newWorkStealingPool(int parallelism) {
        return new ForkJoinPool(parallelism, ForkJoinPool.defaultForkJoinWorkerThreadFactory, null, true);
    }

    /** A pool of one thread that cannot be reconfigured. */
    public static ExecutorService newSingleThreadExecutor() {
        return newSingleThreadExecutor(defaultThreadFactory());
    }

    /** A pool of one thread that cannot be reconfigured. */
    public static ExecutorService newSingleThreadExecutor(ThreadFactory threadFactory) {
        return unconfigurableExecutorService(newFixedThreadPool(1, threadFactory));
    }

    /** A pool that makes threads as needed and keeps idle ones for 60 s. */
    public static ExecutorService newCachedThreadPool() {
        return newCachedThreadPool(defaultThreadFactory());
    }

    /** A pool that makes threads as needed and keeps idle ones for 60 s. */
    public static ExecutorService newCachedThreadPool(ThreadFactory threadFactory) {
        return new ThreadPoolExecutor(0, Integer.MAX_VALUE, CACHED_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(),
                threadFactory);
    }

    /** A scheduler of one thread that cannot be reconfigured. */
    public static ScheduledExecutorService newSingleThreadScheduledExecutor() {
        return newSingleThreadScheduledExecutor(defaultThreadFactory());
    }

    /** A scheduler of one thread that cannot be reconfigured. */
    public static ScheduledExecutorService newSingleThreadScheduledExecutor(ThreadFactory threadFactory) {
        return unconfigurableScheduledExecutorService(newScheduledThreadPool(1, threadFactory));
    }

    /** A scheduler of {@code corePoolSize} threads. */
    public static ScheduledExecutorService newScheduledThreadPool(int corePoolSize) {
        return newScheduledThreadPool(corePoolSize, defaultThreadFactory());
    }

    /** A scheduler of {@code corePoolSize} threads. */
    public static ScheduledExecutorService newScheduledThreadPool(int corePoolSize, ThreadFactory threadFactory) {
        return new ScheduledThreadPoolExecutor(corePoolSize, threadFactory);
    }

    /** Hides everything but the methods of the interface. */
    public static ExecutorService unconfigurableExecutorService(ExecutorService executor) {
        return new DelegatedExecutorService(Objects.requireNonNull(executor));
    }

    /** Hides everything but the methods of the interface. */
    public static ScheduledExecutorService unconfigurableScheduledExecutorService(ScheduledExecutorService executor) {
        return new DelegatedScheduledExecutorService(Objects.requireNonNull(executor));
    }

    /** Makes threads named pool-N-thread-M: not daemons, of normal priority. */
    public static ThreadFactory defaultThreadFactory() {
        return new DefaultThreadFactory();
    }

    /** The same as {@link #defaultThreadFactory}. */
    public static ThreadFactory privilegedThreadFactory() {
        return defaultThreadFactory();
    }

    /** A callable that runs {@code task} and returns {@code result}. */
    public static <T> Callable<T> callable(Runnable task, T result) {
        Objects.requireNonNull(task);
        return () -> {
            task.run();
            return result;
        };
    }

    /** A callable that runs {@code task} and returns null. */
    public static Callable<Object> callable(Runnable task) {
        return callable(task, null);
    }

    /** A callable that runs {@code action}. */
    public static Callable<Object> callable(PrivilegedAction<?> action) {
        Objects.requireNonNull(action);
        return action::run;
    }

    /** A callable that runs {@code action}. */
    public static Callable<Object> callable(PrivilegedExceptionAction<?> action) {
        Objects.requireNonNull(action);
        return action::run;
    }

    /** {@code callable} itself. */
    public static <T> Callable<T> privilegedCallable(Callable<T> callable) {
        return Objects.requireNonNull(callable);
    }

    /** {@code callable} itself. */
    public static <T> Callable<T> privilegedCallableUsingCurrentClassLoader(Callable<T> callable) {
        return Objects.requireNonNull(callable);
    }

    private static final class DefaultThreadFactory implements ThreadFactory {
        private static final AtomicInteger POOLS = new AtomicInteger();

        private final AtomicInteger threads = new AtomicInteger();
        private final String prefix = "pool-" + POOLS.incrementAndGet() + "-thread-";

        @Override
        public Thread newThread(Runnable task) {
            Thread thread = new Thread(task, prefix + threads.incrementAndGet());
            thread.setDaemon(false);
            thread.setPriority(Thread.NORM_PRIORITY);
            return thread;
        }
    }
}
