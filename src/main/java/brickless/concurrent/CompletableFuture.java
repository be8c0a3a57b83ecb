package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * The JDK's CompletableFuture with everything that blocks, or makes threads, replaced. Completing a future and running its dependents
 * needs no locks there, so that part stays the JDK's; stages made from this one are of this class again.
 *
 * <p>With one processor the common pool has no parallelism, so asynchronous stages without an executor get a thread each, as the
 * documentation says.
 */
public class CompletableFuture<T> extends java.util.concurrent.CompletableFuture<T> implements CompletionStage<T> {
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
    public static <U> CompletableFuture<U> supplyAsync(Supplier<U> supplier) {
        return supplyAsync(supplier, THREAD_PER_TASK);
    }

    /** Runs {@code supplier} on {@code executor} and completes with its result. */
    public static <U> CompletableFuture<U> supplyAsync(Supplier<U> supplier, Executor executor) {
        return new CompletableFuture<U>().completeAsync(supplier, executor);
    }

    /** Runs {@code runnable} in a thread of its own. */
    public static CompletableFuture<Void> runAsync(Runnable runnable) {
        return runAsync(runnable, THREAD_PER_TASK);
    }

    /** Runs {@code runnable} on {@code executor}. */
    public static CompletableFuture<Void> runAsync(Runnable runnable, Executor executor) {
        Objects.requireNonNull(runnable);
        return supplyAsync(() -> {
            runnable.run();
            return null;
        }, executor);
    }

    /** A future that is complete. */
    public static <U> CompletableFuture<U> completedFuture(U value) {
        CompletableFuture<U> future = new CompletableFuture<>();
        future.complete(value);
        return future;
    }

    /** A future that has failed. */
    public static <U> CompletableFuture<U> failedFuture(Throwable ex) {
        CompletableFuture<U> future = new CompletableFuture<>();
        future.completeExceptionally(ex);
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

    /** A future that completes when all have; fails if one of them failed. */
    public static CompletableFuture<Void> allOf(CompletableFuture<?>... cfs) {
        return adopt(java.util.concurrent.CompletableFuture.allOf(cfs));
    }

    /** A future that completes or fails like the first of them that does. */
    public static CompletableFuture<Object> anyOf(CompletableFuture<?>... cfs) {
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

    /** Stages of a future of this class are of this class: see {@link #newIncompleteFuture}. */
    private static <U> CompletableFuture<U> own(java.util.concurrent.CompletableFuture<U> stage) {
        return (CompletableFuture<U>) stage;
    }

    /** Chooses the method of the JDK among the overloaded ones. */
    private static <U> java.util.concurrent.CompletionStage<U> original(CompletionStage<U> stage) {
        return stage;
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

    @Override
    public CompletableFuture<T> completeAsync(Supplier<? extends T> supplier, Executor executor) {
        super.completeAsync(supplier, executor);
        return this;
    }

    @Override
    public CompletableFuture<T> completeAsync(Supplier<? extends T> supplier) {
        return completeAsync(supplier, defaultExecutor());
    }

    @Override
    public CompletableFuture<T> copy() {
        return own(super.copy());
    }

    /** A copy; unlike the original's it may be cast to a CompletableFuture and completed on its own. */
    @Override
    public CompletionStage<T> minimalCompletionStage() {
        return copy();
    }

    @Override
    public CompletableFuture<T> toCompletableFuture() {
        return this;
    }

    @Override
    public <U> CompletableFuture<U> thenApply(Function<? super T, ? extends U> fn) {
        return own(super.thenApply(fn));
    }

    @Override
    public <U> CompletableFuture<U> thenApplyAsync(Function<? super T, ? extends U> fn) {
        return own(super.thenApplyAsync(fn));
    }

    @Override
    public <U> CompletableFuture<U> thenApplyAsync(Function<? super T, ? extends U> fn, Executor executor) {
        return own(super.thenApplyAsync(fn, executor));
    }

    @Override
    public CompletableFuture<Void> thenAccept(Consumer<? super T> action) {
        return own(super.thenAccept(action));
    }

    @Override
    public CompletableFuture<Void> thenAcceptAsync(Consumer<? super T> action) {
        return own(super.thenAcceptAsync(action));
    }

    @Override
    public CompletableFuture<Void> thenAcceptAsync(Consumer<? super T> action, Executor executor) {
        return own(super.thenAcceptAsync(action, executor));
    }

    @Override
    public CompletableFuture<Void> thenRun(Runnable action) {
        return own(super.thenRun(action));
    }

    @Override
    public CompletableFuture<Void> thenRunAsync(Runnable action) {
        return own(super.thenRunAsync(action));
    }

    @Override
    public CompletableFuture<Void> thenRunAsync(Runnable action, Executor executor) {
        return own(super.thenRunAsync(action, executor));
    }

    @Override
    public <U, V> CompletableFuture<V> thenCombine(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn) {
        return own(super.thenCombine(original(other), fn));
    }

    @Override
    public <U, V> CompletableFuture<V> thenCombineAsync(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn) {
        return own(super.thenCombineAsync(original(other), fn));
    }

    @Override
    public <U, V> CompletableFuture<V> thenCombineAsync(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn, Executor executor) {
        return own(super.thenCombineAsync(original(other), fn, executor));
    }

    @Override
    public <U> CompletableFuture<Void> thenAcceptBoth(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action) {
        return own(super.thenAcceptBoth(original(other), action));
    }

    @Override
    public <U> CompletableFuture<Void> thenAcceptBothAsync(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action) {
        return own(super.thenAcceptBothAsync(original(other), action));
    }

    @Override
    public <U> CompletableFuture<Void> thenAcceptBothAsync(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action, Executor executor) {
        return own(super.thenAcceptBothAsync(original(other), action, executor));
    }

    @Override
    public CompletableFuture<Void> runAfterBoth(CompletionStage<?> other, Runnable action) {
        return own(super.runAfterBoth(original(other), action));
    }

    @Override
    public CompletableFuture<Void> runAfterBothAsync(CompletionStage<?> other, Runnable action) {
        return own(super.runAfterBothAsync(original(other), action));
    }

    @Override
    public CompletableFuture<Void> runAfterBothAsync(CompletionStage<?> other, Runnable action, Executor executor) {
        return own(super.runAfterBothAsync(original(other), action, executor));
    }

    @Override
    public <U> CompletableFuture<U> applyToEither(CompletionStage<? extends T> other, Function<? super T, U> fn) {
        return own(super.applyToEither(original(other), fn));
    }

    @Override
    public <U> CompletableFuture<U> applyToEitherAsync(CompletionStage<? extends T> other, Function<? super T, U> fn) {
        return own(super.applyToEitherAsync(original(other), fn));
    }

    @Override
    public <U> CompletableFuture<U> applyToEitherAsync(
            CompletionStage<? extends T> other, Function<? super T, U> fn, Executor executor) {
        return own(super.applyToEitherAsync(original(other), fn, executor));
    }

    @Override
    public CompletableFuture<Void> acceptEither(CompletionStage<? extends T> other, Consumer<? super T> action) {
        return own(super.acceptEither(original(other), action));
    }

    @Override
    public CompletableFuture<Void> acceptEitherAsync(CompletionStage<? extends T> other, Consumer<? super T> action) {
        return own(super.acceptEitherAsync(original(other), action));
    }

    @Override
    public CompletableFuture<Void> acceptEitherAsync(
            CompletionStage<? extends T> other, Consumer<? super T> action, Executor executor) {
        return own(super.acceptEitherAsync(original(other), action, executor));
    }

    @Override
    public CompletableFuture<Void> runAfterEither(CompletionStage<?> other, Runnable action) {
        return own(super.runAfterEither(original(other), action));
    }

    @Override
    public CompletableFuture<Void> runAfterEitherAsync(CompletionStage<?> other, Runnable action) {
        return own(super.runAfterEitherAsync(original(other), action));
    }

    @Override
    public CompletableFuture<Void> runAfterEitherAsync(CompletionStage<?> other, Runnable action, Executor executor) {
        return own(super.runAfterEitherAsync(original(other), action, executor));
    }

    @Override
    public <U> CompletableFuture<U> thenCompose(
            Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn) {
        return own(super.thenCompose(fn));
    }

    @Override
    public <U> CompletableFuture<U> thenComposeAsync(
            Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn) {
        return own(super.thenComposeAsync(fn));
    }

    @Override
    public <U> CompletableFuture<U> thenComposeAsync(
            Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn, Executor executor) {
        return own(super.thenComposeAsync(fn, executor));
    }

    @Override
    public <U> CompletableFuture<U> handle(BiFunction<? super T, Throwable, ? extends U> fn) {
        return own(super.handle(fn));
    }

    @Override
    public <U> CompletableFuture<U> handleAsync(BiFunction<? super T, Throwable, ? extends U> fn) {
        return own(super.handleAsync(fn));
    }

    @Override
    public <U> CompletableFuture<U> handleAsync(BiFunction<? super T, Throwable, ? extends U> fn, Executor executor) {
        return own(super.handleAsync(fn, executor));
    }

    @Override
    public CompletableFuture<T> whenComplete(BiConsumer<? super T, ? super Throwable> action) {
        return own(super.whenComplete(action));
    }

    @Override
    public CompletableFuture<T> whenCompleteAsync(BiConsumer<? super T, ? super Throwable> action) {
        return own(super.whenCompleteAsync(action));
    }

    @Override
    public CompletableFuture<T> whenCompleteAsync(BiConsumer<? super T, ? super Throwable> action, Executor executor) {
        return own(super.whenCompleteAsync(action, executor));
    }

    @Override
    public CompletableFuture<T> exceptionally(Function<Throwable, ? extends T> fn) {
        return own(super.exceptionally(fn));
    }

    @Override
    public CompletableFuture<T> exceptionallyAsync(Function<Throwable, ? extends T> fn) {
        return own(super.exceptionallyAsync(fn));
    }

    @Override
    public CompletableFuture<T> exceptionallyAsync(Function<Throwable, ? extends T> fn, Executor executor) {
        return own(super.exceptionallyAsync(fn, executor));
    }

    @Override
    public CompletableFuture<T> exceptionallyCompose(
            Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn) {
        return own(super.exceptionallyCompose(fn));
    }

    @Override
    public CompletableFuture<T> exceptionallyComposeAsync(
            Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn) {
        return own(super.exceptionallyComposeAsync(fn));
    }

    @Override
    public CompletableFuture<T> exceptionallyComposeAsync(
            Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn, Executor executor) {
        return own(super.exceptionallyComposeAsync(fn, executor));
    }
}
