package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;

/**
 * The JDK's CompletableFuture with everything that blocks, or makes threads, replaced. Completing a future and running
 * its dependents needs no locks there, so that part stays the JDK's; stages made from a future of this class are of
 * this class again.
 *
 * <p>Programs go on using the JDK's type: the loader only makes them construct this class and call its static methods,
 * which therefore have the JDK's signatures. With one processor the common pool has no parallelism, so asynchronous
 * stages without an executor get a thread each, as the documentation says.
 */
public class CompletableFuture<T> extends java.util.concurrent.CompletableFuture<T> {
    private static final Executor THREAD_PER_TASK = task -> new Thread(task).start();

    /** Runs what has to happen later; made when first needed. */
    private static final class Delayer {
        static final ScheduledThreadPoolExecutor TIMER = new ScheduledThreadPoolExecutor(1, task -> {
            Thread thread = new Thread(task, "CompletableFutureDelayScheduler");
            thread.setDaemon(true);
            return thread;
        });

        static {
            TIMER.setRemoveOnCancelPolicy(true);
        }
    }

    /** Creates a future that is not complete. */
    public CompletableFuture() {
    }

    @Override
    public <U> CompletableFuture<U> newIncompleteFuture() {
        return new CompletableFuture<>();
    }

    @Override
    public Executor defaultExecutor() {
        return THREAD_PER_TASK;
    }

    /** Runs {@code supplier} in a thread of its own and completes with its result. */
    public static <U> java.util.concurrent.CompletableFuture<U> supplyAsync(Supplier<U> supplier) {
        return supplyAsync(supplier, THREAD_PER_TASK);
    }

    /** Runs {@code supplier} on {@code executor} and completes with its result. */
    public static <U> java.util.concurrent.CompletableFuture<U> supplyAsync(Supplier<U> supplier, Executor executor) {
        return new CompletableFuture<U>().completeAsync(supplier, executor);
    }

    /** Runs {@code runnable} in a thread of its own. */
    public static java.util.concurrent.CompletableFuture<Void> runAsync(Runnable runnable) {
        return runAsync(runnable, THREAD_PER_TASK);
    }

    /** Runs {@code runnable} on {@code executor}. */
    public static java.util.concurrent.CompletableFuture<Void> runAsync(Runnable runnable, Executor executor) {
        Objects.requireNonNull(runnable);
        return supplyAsync(() -> {
            runnable.run();
            return null;
        }, executor);
    }

    /** A future that is complete. */
    public static <U> java.util.concurrent.CompletableFuture<U> completedFuture(U value) {
        CompletableFuture<U> future = new CompletableFuture<>();
        future.complete(value);
        return future;
    }

    /** A future that has failed. */
    public static <U> java.util.concurrent.CompletableFuture<U> failedFuture(Throwable ex) {
        CompletableFuture<U> future = new CompletableFuture<>();
        future.completeExceptionally(Objects.requireNonNull(ex));
        return future;
    }

    /** A stage that is complete. */
    public static <U> CompletionStage<U> completedStage(U value) {
        return completedFuture(value);
    }

    /** A stage that has failed. */
    public static <U> CompletionStage<U> failedStage(Throwable ex) {
        return failedFuture(ex);
    }

    /** A copy; unlike the original's it may be cast to a CompletableFuture and completed on its own. */
    @Override
    public CompletionStage<T> minimalCompletionStage() {
        return copy();
    }

    /** A future that completes when all have; fails if one of them failed. */
    public static java.util.concurrent.CompletableFuture<Void> allOf(java.util.concurrent.CompletableFuture<?>... cfs) {
        return adopt(java.util.concurrent.CompletableFuture.allOf(cfs));
    }

    /** A future that completes or fails like the first of them that does. */
    public static java.util.concurrent.CompletableFuture<Object> anyOf(
            java.util.concurrent.CompletableFuture<?>... cfs) {
        return adopt(java.util.concurrent.CompletableFuture.anyOf(cfs));
    }

    private static <U> CompletableFuture<U> adopt(java.util.concurrent.CompletableFuture<U> original) {
        CompletableFuture<U> future = new CompletableFuture<>();
        original.whenComplete((value, thrown) -> {
            if (thrown == null) {
                future.complete(value);
            } else {
                future.completeExceptionally(thrown);
            }
        });
        return future;
    }

    /** Hands tasks to {@code executor} after a delay. */
    public static Executor delayedExecutor(long delay, TimeUnit unit, Executor executor) {
        Objects.requireNonNull(unit);
        Objects.requireNonNull(executor);
        return task -> Delayer.TIMER.schedule(() -> executor.execute(task), delay, unit);
    }

    /** Runs tasks in threads of their own after a delay. */
    public static Executor delayedExecutor(long delay, TimeUnit unit) {
        return delayedExecutor(delay, unit, THREAD_PER_TASK);
    }

    @Override
    public T get() throws InterruptedException, ExecutionException {
        await(Deadline.NEVER);
        return super.get();
    }

    @Override
    public T get(long timeout, TimeUnit unit) throws InterruptedException, ExecutionException, TimeoutException {
        if (!await(Deadline.after(timeout, unit))) {
            throw new TimeoutException();
        }
        return super.get();
    }

    @Override
    public T join() {
        boolean interrupted = false;
        while (!isDone()) {
            try {
                await(Deadline.NEVER);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        return super.join();
    }

    private boolean await(Deadline deadline) throws InterruptedException {
        if (isDone()) {
            return true;
        }
        CountDownLatch done = new CountDownLatch(1);
        super.whenComplete((value, thrown) -> done.countDown());
        return done.await(deadline.nanosLeft(), TimeUnit.NANOSECONDS);
    }

    @Override
    public CompletableFuture<T> orTimeout(long timeout, TimeUnit unit) {
        return later(() -> completeExceptionally(new TimeoutException()), timeout, unit);
    }

    @Override
    public CompletableFuture<T> completeOnTimeout(T value, long timeout, TimeUnit unit) {
        return later(() -> complete(value), timeout, unit);
    }

    private CompletableFuture<T> later(Runnable completion, long timeout, TimeUnit unit) {
        Objects.requireNonNull(unit);
        if (!isDone()) {
            Future<?> pending = Delayer.TIMER.schedule(completion, timeout, unit);
            super.whenComplete((value, thrown) -> pending.cancel(false));
        }
        return this;
    }
}
