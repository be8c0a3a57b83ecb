package brickless.concurrent;

import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * {@code java.util.concurrent.CompletionStage} with results and arguments of this type, because the original names
 * {@code CompletableFuture} in its signatures. Every method means what the method that it overloads or overrides means.
 */
public interface CompletionStage<T> extends java.util.concurrent.CompletionStage<T> {
    @Override
    CompletableFuture<T> toCompletableFuture();

    @Override
    <U> CompletionStage<U> thenApply(Function<? super T, ? extends U> fn);

    @Override
    <U> CompletionStage<U> thenApplyAsync(Function<? super T, ? extends U> fn);

    @Override
    <U> CompletionStage<U> thenApplyAsync(Function<? super T, ? extends U> fn, Executor executor);

    @Override
    CompletionStage<Void> thenAccept(Consumer<? super T> action);

    @Override
    CompletionStage<Void> thenAcceptAsync(Consumer<? super T> action);

    @Override
    CompletionStage<Void> thenAcceptAsync(Consumer<? super T> action, Executor executor);

    @Override
    CompletionStage<Void> thenRun(Runnable action);

    @Override
    CompletionStage<Void> thenRunAsync(Runnable action);

    @Override
    CompletionStage<Void> thenRunAsync(Runnable action, Executor executor);

    /** See the overloaded method. */
    <U, V> CompletionStage<V> thenCombine(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn);

    /** See the overloaded method. */
    <U, V> CompletionStage<V> thenCombineAsync(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn);

    /** See the overloaded method. */
    <U, V> CompletionStage<V> thenCombineAsync(
            CompletionStage<? extends U> other, BiFunction<? super T, ? super U, ? extends V> fn, Executor executor);

    /** See the overloaded method. */
    <U> CompletionStage<Void> thenAcceptBoth(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action);

    /** See the overloaded method. */
    <U> CompletionStage<Void> thenAcceptBothAsync(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action);

    /** See the overloaded method. */
    <U> CompletionStage<Void> thenAcceptBothAsync(
            CompletionStage<? extends U> other, BiConsumer<? super T, ? super U> action, Executor executor);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterBoth(CompletionStage<?> other, Runnable action);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterBothAsync(CompletionStage<?> other, Runnable action);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterBothAsync(CompletionStage<?> other, Runnable action, Executor executor);

    /** See the overloaded method. */
    <U> CompletionStage<U> applyToEither(CompletionStage<? extends T> other, Function<? super T, U> fn);

    /** See the overloaded method. */
    <U> CompletionStage<U> applyToEitherAsync(CompletionStage<? extends T> other, Function<? super T, U> fn);

    /** See the overloaded method. */
    <U> CompletionStage<U> applyToEitherAsync(
            CompletionStage<? extends T> other, Function<? super T, U> fn, Executor executor);

    /** See the overloaded method. */
    CompletionStage<Void> acceptEither(CompletionStage<? extends T> other, Consumer<? super T> action);

    /** See the overloaded method. */
    CompletionStage<Void> acceptEitherAsync(CompletionStage<? extends T> other, Consumer<? super T> action);

    /** See the overloaded method. */
    CompletionStage<Void> acceptEitherAsync(
            CompletionStage<? extends T> other, Consumer<? super T> action, Executor executor);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterEither(CompletionStage<?> other, Runnable action);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterEitherAsync(CompletionStage<?> other, Runnable action);

    /** See the overloaded method. */
    CompletionStage<Void> runAfterEitherAsync(CompletionStage<?> other, Runnable action, Executor executor);

    @Override
    <U> CompletionStage<U> thenCompose(Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn);

    @Override
    <U> CompletionStage<U> thenComposeAsync(Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn);

    @Override
    <U> CompletionStage<U> thenComposeAsync(
            Function<? super T, ? extends java.util.concurrent.CompletionStage<U>> fn, Executor executor);

    @Override
    <U> CompletionStage<U> handle(BiFunction<? super T, Throwable, ? extends U> fn);

    @Override
    <U> CompletionStage<U> handleAsync(BiFunction<? super T, Throwable, ? extends U> fn);

    @Override
    <U> CompletionStage<U> handleAsync(BiFunction<? super T, Throwable, ? extends U> fn, Executor executor);

    @Override
    CompletionStage<T> whenComplete(BiConsumer<? super T, ? super Throwable> action);

    @Override
    CompletionStage<T> whenCompleteAsync(BiConsumer<? super T, ? super Throwable> action);

    @Override
    CompletionStage<T> whenCompleteAsync(BiConsumer<? super T, ? super Throwable> action, Executor executor);

    @Override
    CompletionStage<T> exceptionally(Function<Throwable, ? extends T> fn);

    @Override
    CompletionStage<T> exceptionallyAsync(Function<Throwable, ? extends T> fn);

    @Override
    CompletionStage<T> exceptionallyAsync(Function<Throwable, ? extends T> fn, Executor executor);

    @Override
    CompletionStage<T> exceptionallyCompose(Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn);

    @Override
    CompletionStage<T> exceptionallyComposeAsync(
            Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn);

    @Override
    CompletionStage<T> exceptionallyComposeAsync(
            Function<Throwable, ? extends java.util.concurrent.CompletionStage<T>> fn, Executor executor);
}
