package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;

/**
 * {@code java.util.concurrent.ThreadPoolExecutor} on virtual threads and monitors.
 *
 * <p>One monitor guards all state. The queue is never called with it held where it could block, nor are tasks or the
 * rejection handler.
 */
public class ThreadPoolExecutor extends AbstractExecutorService {
    private enum Phase {
        RUNNING, SHUTDOWN, STOP, TERMINATED
    }

    private final Object monitor = new Object();
    private final BlockingQueue<Runnable> queue;
    // Guarded by the monitor:
    private final Set<Worker> workers = new LinkedHashSet<>();
    private Phase phase = Phase.RUNNING;
    private int corePoolSize;
    private int maximumPoolSize;
    private long keepAliveNanos;
    private boolean coreTimeOut;
    private ThreadFactory threadFactory;
    private RejectedExecutionHandler handler;
    private int largestPoolSize;
    private long completedBefore;

    /** A thread of the pool; its fields are guarded by the monitor. */
    private final class Worker implements Runnable {
        private Runnable first;
        private Thread thread;
        private boolean busy;
        private long completed;

        Worker(Runnable first) {
            this.first = first;
        }

        @Override
        public void run() {
            boolean normal = false;
            try {
                Runnable task = first;
                first = null;
                while (task != null || (task = nextTask(this)) != null) {
                    runTask(this, task);
                    task = null;
                }
                normal = true;
            } finally {
                exit(this, normal);
            }
        }
    }

    /** Creates a pool with default thread factory and {@link AbortPolicy}. */
    public ThreadPoolExecutor(int corePoolSize, int maximumPoolSize, long keepAliveTime, TimeUnit unit,
            BlockingQueue<Runnable> workQueue) {
        this(corePoolSize, maximumPoolSize, keepAliveTime, unit, workQueue, Executors.defaultThreadFactory());
    }

    /** Creates a pool with {@link AbortPolicy}. */
    public ThreadPoolExecutor(int corePoolSize, int maximumPoolSize, long keepAliveTime, TimeUnit unit,
            BlockingQueue<Runnable> workQueue, ThreadFactory threadFactory) {
        this(corePoolSize, maximumPoolSize, keepAliveTime, unit, workQueue, threadFactory, new AbortPolicy());
    }

    /** Creates a pool with default thread factory. */
    public ThreadPoolExecutor(int corePoolSize, int maximumPoolSize, long keepAliveTime, TimeUnit unit,
            BlockingQueue<Runnable> workQueue, RejectedExecutionHandler handler) {
        this(corePoolSize, maximumPoolSize, keepAliveTime, unit, workQueue, Executors.defaultThreadFactory(), handler);
    }

    /**
     * Creates a pool; IllegalArgumentException for sizes or a time that make no sense, NullPointerException for nulls.
     */
    public ThreadPoolExecutor(int corePoolSize, int maximumPoolSize, long keepAliveTime, TimeUnit unit,
            BlockingQueue<Runnable> workQueue, ThreadFactory threadFactory, RejectedExecutionHandler handler) {
        requireArgument(corePoolSize >= 0 && maximumPoolSize > 0 && maximumPoolSize >= corePoolSize
                && keepAliveTime >= 0);
        this.queue = Objects.requireNonNull(workQueue);
        this.threadFactory = Objects.requireNonNull(threadFactory);
        this.handler = Objects.requireNonNull(handler);
        this.corePoolSize = corePoolSize;
        this.maximumPoolSize = maximumPoolSize;
        this.keepAliveNanos = unit.toNanos(keepAliveTime);
    }

    private static void requireArgument(boolean good) {
        if (!good) {
            throw new IllegalArgumentException();
        }
    }

    @Override
    public void execute(Runnable command) {
        Objects.requireNonNull(command);
        synchronized (monitor) {
            if (phase == Phase.RUNNING && workers.size() < corePoolSize && addWorker(command)) {
                return;
            }
        }
        boolean accepted = !isShutdown() && queue.offer(command) ? confirmQueued(command) : addExtraWorker(command);
        if (!accepted) {
            reject(command);
        }
    }

    /** The pool may have been shut down, or have lost its last worker, while the task was being queued. */
    private boolean confirmQueued(Runnable command) {
        synchronized (monitor) {
            if (phase != Phase.RUNNING && remove(command)) {
                return false;
            }
            if (workers.isEmpty()) {
                addWorker(null);
            }
            return true;
        }
    }

    private boolean addExtraWorker(Runnable command) {
        synchronized (monitor) {
            return phase == Phase.RUNNING && workers.size() < maximumPoolSize && addWorker(command);
        }
    }

    final void reject(Runnable command) {
        getRejectedExecutionHandler().rejectedExecution(command, this);
    }

    /** Starts a thread, with the monitor held; false if the factory refuses. */
    private boolean addWorker(Runnable first) {
        Worker worker = new Worker(first);
        worker.thread = threadFactory.newThread(worker);
        if (worker.thread == null) {
            return false;
        }
        workers.add(worker);
        largestPoolSize = Math.max(largestPoolSize, workers.size());
        boolean started = false;
        try {
            worker.thread.start();
            started = true;
        } finally {
            if (!started) {
                workers.remove(worker);
            }
        }
        return true;
    }

    /** Waits for a task; null if the worker has to end. */
    private Runnable nextTask(Worker worker) {
        boolean timedOut = false;
        while (true) {
            long patience;
            synchronized (monitor) {
                if (mustEnd(timedOut)) {
                    workers.remove(worker);
                    completedBefore += worker.completed;
                    worker.completed = 0;
                    return null;
                }
                patience = mayTimeOut() ? keepAliveNanos : Long.MAX_VALUE;
            }
            try {
                Runnable task = patience == Long.MAX_VALUE ? queue.take() : queue.poll(patience, TimeUnit.NANOSECONDS);
                if (task != null) {
                    return task;
                }
                timedOut = true;
            } catch (InterruptedException e) {
                // A sign that something changed: look again whether to go on.
                timedOut = false;
            }
        }
    }

    private boolean mustEnd(boolean timedOut) {
        if (phase.compareTo(Phase.STOP) >= 0 || phase == Phase.SHUTDOWN && queue.isEmpty()) {
            return true;
        }
        boolean surplus = workers.size() > maximumPoolSize || timedOut && mayTimeOut();
        return surplus && (workers.size() > 1 || queue.isEmpty());
    }

    private boolean mayTimeOut() {
        return coreTimeOut || workers.size() > corePoolSize;
    }

    private void runTask(Worker worker, Runnable task) {
        synchronized (monitor) {
            worker.busy = true;
            // An interrupt that was meant for the idle worker must not reach the task; one that stops the pool must.
            Thread.interrupted();
            if (phase.compareTo(Phase.STOP) >= 0) {
                worker.thread.interrupt();
            }
        }
        try {
            runHooked(worker.thread, task);
        } finally {
            synchronized (monitor) {
                worker.busy = false;
                worker.completed++;
                monitor.notifyAll();
            }
        }
    }

    private void runHooked(Thread thread, Runnable task) {
        beforeExecute(thread, task);
        try {
            task.run();
        } catch (Throwable t) {
            afterExecute(task, t);
            throw t;
        }
        afterExecute(task, null);
    }

    private void exit(Worker worker, boolean normal) {
        synchronized (monitor) {
            workers.remove(worker);
            completedBefore += worker.completed;
            terminateIfDone();
            if (mayStillWork() && (!normal || workers.size() < smallestUsefulSize())) {
                addWorker(null);
            }
        }
    }

    private boolean mayStillWork() {
        return phase == Phase.RUNNING || phase == Phase.SHUTDOWN && !queue.isEmpty();
    }

    private int smallestUsefulSize() {
        int waiting = queue.isEmpty() ? 0 : 1;
        return coreTimeOut ? waiting : Math.max(corePoolSize, waiting);
    }

    /** Ends the pool when nothing is left to do, or tells idle workers to end; with the monitor held. */
    private void terminateIfDone() {
        boolean nothingLeft = phase == Phase.STOP || phase == Phase.SHUTDOWN && queue.isEmpty();
        if (!nothingLeft) {
            return;
        }
        if (!workers.isEmpty()) {
            interruptIdle();
            return;
        }
        try {
            terminated();
        } finally {
            phase = Phase.TERMINATED;
            monitor.notifyAll();
        }
    }

    private void interruptIdle() {
        for (Worker worker : workers) {
            if (!worker.busy) {
                worker.thread.interrupt();
            }
        }
    }

    @Override
    public void shutdown() {
        synchronized (monitor) {
            if (phase == Phase.RUNNING) {
                phase = Phase.SHUTDOWN;
            }
            interruptIdle();
            onShutdown();
            terminateIfDone();
        }
    }

    /** What else to do at shutdown; with the monitor held. */
    void onShutdown() {
    }

    @Override
    public List<Runnable> shutdownNow() {
        synchronized (monitor) {
            if (phase.compareTo(Phase.STOP) < 0) {
                phase = Phase.STOP;
            }
            for (Worker worker : workers) {
                worker.thread.interrupt();
            }
            // Not drainTo: a delay queue would keep what is not due.
            List<Runnable> waiting = new ArrayList<>(queue);
            waiting.removeIf(task -> !queue.remove(task));
            terminateIfDone();
            return waiting;
        }
    }

    @Override
    public boolean isShutdown() {
        synchronized (monitor) {
            return phase != Phase.RUNNING;
        }
    }

    /** Whether a shutdown has begun but not ended. */
    public boolean isTerminating() {
        synchronized (monitor) {
            return phase != Phase.RUNNING && phase != Phase.TERMINATED;
        }
    }

    @Override
    public boolean isTerminated() {
        synchronized (monitor) {
            return phase == Phase.TERMINATED;
        }
    }

    /** Whether queued tasks are given up. */
    final boolean isStopped() {
        synchronized (monitor) {
            return phase.compareTo(Phase.STOP) >= 0;
        }
    }

    @Override
    public boolean awaitTermination(long timeout, TimeUnit unit) throws InterruptedException {
        Deadline deadline = Deadline.after(timeout, unit);
        synchronized (monitor) {
            while (phase != Phase.TERMINATED) {
                if (!deadline.await(monitor)) {
                    return false;
                }
            }
            return true;
        }
    }

    /** Waits until no task is waiting or running, even when interrupted; false if the deadline passed first. */
    final boolean awaitIdle(Deadline deadline) {
        boolean interrupted = false;
        synchronized (monitor) {
            while (!queue.isEmpty() || getActiveCount() > 0) {
                try {
                    if (!deadline.await(monitor)) {
                        break;
                    }
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
            return queue.isEmpty() && getActiveCount() == 0;
        }
    }

    /** Called in the worker before each task; does nothing. */
    protected void beforeExecute(Thread t, Runnable r) {
    }

    /** Called in the worker after each task, with what it threw or null; does nothing. */
    protected void afterExecute(Runnable r, Throwable t) {
    }

    /** Called once when the pool has terminated; does nothing. */
    protected void terminated() {
    }

    /** Sets what makes new threads. */
    public void setThreadFactory(ThreadFactory threadFactory) {
        synchronized (monitor) {
            this.threadFactory = Objects.requireNonNull(threadFactory);
        }
    }

    /** What makes new threads. */
    public ThreadFactory getThreadFactory() {
        synchronized (monitor) {
            return threadFactory;
        }
    }

    /** Sets what happens to tasks that cannot be accepted. */
    public void setRejectedExecutionHandler(RejectedExecutionHandler handler) {
        synchronized (monitor) {
            this.handler = Objects.requireNonNull(handler);
        }
    }

    /** What happens to tasks that cannot be accepted. */
    public RejectedExecutionHandler getRejectedExecutionHandler() {
        synchronized (monitor) {
            return handler;
        }
    }

    /** Sets the number of threads that are kept; superfluous idle ones end, missing ones start if tasks wait. */
    public void setCorePoolSize(int corePoolSize) {
        synchronized (monitor) {
            requireArgument(corePoolSize >= 0 && corePoolSize <= maximumPoolSize);
            int more = Math.min(corePoolSize - this.corePoolSize, queue.size());
            this.corePoolSize = corePoolSize;
            if (workers.size() > corePoolSize) {
                interruptIdle();
            }
            while (more > 0 && phase == Phase.RUNNING && workers.size() < corePoolSize && addWorker(null)) {
                more--;
            }
        }
    }

    /** Number of threads that are kept. */
    public int getCorePoolSize() {
        synchronized (monitor) {
            return corePoolSize;
        }
    }

    /** Starts one more core thread; false if all are running. */
    public boolean prestartCoreThread() {
        synchronized (monitor) {
            return phase == Phase.RUNNING && workers.size() < corePoolSize && addWorker(null);
        }
    }

    /** Starts all core threads and returns how many were missing. */
    public int prestartAllCoreThreads() {
        int started = 0;
        while (prestartCoreThread()) {
            started++;
        }
        return started;
    }

    /** Makes sure that somebody will come for a queued task. */
    final void ensureWorker() {
        synchronized (monitor) {
            if (mayStillWork() && (workers.isEmpty() || workers.size() < corePoolSize)) {
                addWorker(null);
            }
        }
    }

    /** Whether core threads end after the keep-alive time, too. */
    public boolean allowsCoreThreadTimeOut() {
        synchronized (monitor) {
            return coreTimeOut;
        }
    }

    /** Sets whether core threads end after the keep-alive time; IllegalArgumentException if that is zero. */
    public void allowCoreThreadTimeOut(boolean value) {
        synchronized (monitor) {
            requireArgument(!value || keepAliveNanos > 0);
            coreTimeOut = value;
            if (value) {
                interruptIdle();
            }
        }
    }

    /** Sets the largest number of threads. */
    public void setMaximumPoolSize(int maximumPoolSize) {
        synchronized (monitor) {
            requireArgument(maximumPoolSize > 0 && maximumPoolSize >= corePoolSize);
            this.maximumPoolSize = maximumPoolSize;
            if (workers.size() > maximumPoolSize) {
                interruptIdle();
            }
        }
    }

    /** Largest number of threads. */
    public int getMaximumPoolSize() {
        synchronized (monitor) {
            return maximumPoolSize;
        }
    }

    /** Sets how long threads above the core size stay idle before they end. */
    public void setKeepAliveTime(long time, TimeUnit unit) {
        synchronized (monitor) {
            requireArgument(time >= 0 && (time > 0 || !coreTimeOut));
            boolean shorter = unit.toNanos(time) < keepAliveNanos;
            keepAliveNanos = unit.toNanos(time);
            if (shorter) {
                interruptIdle();
            }
        }
    }

    /** How long threads above the core size stay idle before they end. */
    public long getKeepAliveTime(TimeUnit unit) {
        synchronized (monitor) {
            return unit.convert(keepAliveNanos, TimeUnit.NANOSECONDS);
        }
    }

    /** The tasks that wait for a thread. */
    public BlockingQueue<Runnable> getQueue() {
        return queue;
    }

    /** Removes a task that waits for a thread. */
    public boolean remove(Runnable task) {
        boolean removed = queue.remove(task);
        synchronized (monitor) {
            terminateIfDone();
        }
        return removed;
    }

    /** Removes cancelled futures from the queue. */
    public void purge() {
        queue.removeIf(task -> task instanceof Future<?> && ((Future<?>) task).isCancelled());
        synchronized (monitor) {
            terminateIfDone();
        }
    }

    /** Number of threads. */
    public int getPoolSize() {
        synchronized (monitor) {
            return workers.size();
        }
    }

    /** Number of threads that run a task. */
    public int getActiveCount() {
        synchronized (monitor) {
            int active = 0;
            for (Worker worker : workers) {
                active += worker.busy ? 1 : 0;
            }
            return active;
        }
    }

    /** Largest number of threads that there ever were. */
    public int getLargestPoolSize() {
        synchronized (monitor) {
            return largestPoolSize;
        }
    }

    /** Number of tasks that were ever accepted. */
    public long getTaskCount() {
        synchronized (monitor) {
            return getCompletedTaskCount() + getActiveCount() + queue.size();
        }
    }

    /** Number of tasks that have ended. */
    public long getCompletedTaskCount() {
        synchronized (monitor) {
            long completed = completedBefore;
            for (Worker worker : workers) {
                completed += worker.completed;
            }
            return completed;
        }
    }

    @Override
    public String toString() {
        synchronized (monitor) {
            String state = phase == Phase.RUNNING ? "Running" : phase == Phase.TERMINATED ? "Terminated"
                    : "Shutting down";
            return super.toString() + "[" + state + ", pool size = " + getPoolSize() + ", active threads = "
                    + getActiveCount()
                    + ", queued tasks = " + queue.size() + ", completed tasks = " + getCompletedTaskCount() + "]";
        }
    }

    /** Runs a rejected task in the thread that wanted to hand it over, unless the pool is shut down. */
    public static class CallerRunsPolicy implements RejectedExecutionHandler {
        /** Creates the policy. */
        public CallerRunsPolicy() {
        }

        @Override
        public void rejectedExecution(Runnable r, ThreadPoolExecutor e) {
            if (!e.isShutdown()) {
                r.run();
            }
        }
    }

    /** Throws RejectedExecutionException. */
    public static class AbortPolicy implements RejectedExecutionHandler {
        /** Creates the policy. */
        public AbortPolicy() {
        }

        @Override
        public void rejectedExecution(Runnable r, ThreadPoolExecutor e) {
            throw new RejectedExecutionException("Task " + r + " rejected from " + e);
        }
    }

    /** Drops a rejected task. */
    public static class DiscardPolicy implements RejectedExecutionHandler {
        /** Creates the policy. */
        public DiscardPolicy() {
        }

        @Override
        public void rejectedExecution(Runnable r, ThreadPoolExecutor e) {
        }
    }

    /** Drops the oldest waiting task and tries again, unless the pool is shut down. */
    public static class DiscardOldestPolicy implements RejectedExecutionHandler {
        /** Creates the policy. */
        public DiscardOldestPolicy() {
        }

        @Override
        public void rejectedExecution(Runnable r, ThreadPoolExecutor e) {
            if (!e.isShutdown()) {
                e.getQueue().poll();
                e.execute(r);
            }
        }
    }
}
