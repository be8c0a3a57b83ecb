package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.RunnableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** {@code java.util.concurrent.AbstractExecutorService}; its futures are virtual. */
public abstract class AbstractExecutorService implements ExecutorService {
    /** Creates the service. */
    public AbstractExecutorService() {
    }

    /** The future that stands for {@code runnable} and {@code value}. */
    protected <T> RunnableFuture<T> newTaskFor(Runnable runnable, T value) {
        return new FutureTask<>(runnable, value);
    }

    /** The future that stands for {@code callable}. */
    protected <T> RunnableFuture<T> newTaskFor(Callable<T> callable) {
        return new FutureTask<>(callable);
    }

    @Override
    public Future<?> submit(Runnable task) {
        return submit(task, null);
    }

    @Override
    public <T> Future<T> submit(Runnable task, T result) {
        return start(newTaskFor(requireTask(task), result));
    }

    @Override
    public <T> Future<T> submit(Callable<T> task) {
        return start(newTaskFor(requireTask(task)));
    }

    private <T> RunnableFuture<T> start(RunnableFuture<T> future) {
        execute(future);
        return future;
    }

    private static <T> T requireTask(T task) {
        if (task == null) {
            throw new NullPointerException();
        }
        return task;
    }

    @Override
    public <T> List<Future<T>> invokeAll(Collection<? extends Callable<T>> tasks) throws InterruptedException {
        return invokeAll(tasks, Deadline.NEVER);
    }

    @Override
    public <T> List<Future<T>> invokeAll(Collection<? extends Callable<T>> tasks, long timeout, TimeUnit unit)
            throws InterruptedException {
        return invokeAll(tasks, Deadline.after(timeout, unit));
    }

    private <T> List<Future<T>> invokeAll(Collection<? extends Callable<T>> tasks, Deadline deadline)
            throws InterruptedException {
        List<Future<T>> futures = new ArrayList<>();
        boolean complete = false;
        try {
            for (Callable<T> task : tasks) {
                futures.add(newTaskFor(requireTask(task)));
            }
            complete = startAll(futures, deadline) && awaitAll(futures, deadline);
        } finally {
            if (!complete) {
                cancelAll(futures);
            }
        }
        return futures;
    }

    private boolean startAll(List<? extends Future<?>> futures, Deadline deadline) {
        for (Future<?> future : futures) {
            if (deadline.passed()) {
                return false;
            }
            execute((Runnable) future);
        }
        return true;
    }

    private static boolean awaitAll(List<? extends Future<?>> futures, Deadline deadline) throws InterruptedException {
        for (Future<?> future : futures) {
            try {
                future.get(deadline.nanosLeft(), TimeUnit.NANOSECONDS);
            } catch (TimeoutException e) {
                return false;
            } catch (ExecutionException | CancellationException e) {
                // A task that failed is complete too; its future tells.
                continue;
            }
        }
        return true;
    }

    private static void cancelAll(Collection<? extends Future<?>> futures) {
        for (Future<?> future : futures) {
            future.cancel(true);
        }
    }

    @Override
    public <T> T invokeAny(Collection<? extends Callable<T>> tasks) throws InterruptedException, ExecutionException {
        try {
            return invokeAny(tasks, Deadline.NEVER);
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public <T> T invokeAny(Collection<? extends Callable<T>> tasks, long timeout, TimeUnit unit)
            throws InterruptedException, ExecutionException, TimeoutException {
        return invokeAny(tasks, Deadline.after(timeout, unit));
    }

    private <T> T invokeAny(Collection<? extends Callable<T>> tasks, Deadline deadline)
            throws InterruptedException, ExecutionException, TimeoutException {
        if (tasks.isEmpty()) {
            throw new IllegalArgumentException("no tasks");
        }
        ExecutorCompletionService<T> completed = new ExecutorCompletionService<>(this);
        List<Future<T>> futures = new ArrayList<>();
        try {
            for (Callable<T> task : tasks) {
                futures.add(completed.submit(task));
            }
            return firstSuccess(completed, futures.size(), deadline);
        } finally {
            cancelAll(futures);
        }
    }

    private static <T> T firstSuccess(ExecutorCompletionService<T> completed, int count, Deadline deadline)
            throws InterruptedException, ExecutionException, TimeoutException {
        ExecutionException failure = null;
        for (int i = 0; i < count; i++) {
            Future<T> next = completed.poll(deadline.nanosLeft(), TimeUnit.NANOSECONDS);
            if (next == null) {
                throw new TimeoutException();
            }
            try {
                return next.get();
            } catch (ExecutionException e) {
                failure = e;
            }
        }
        throw failure;
    }
}
