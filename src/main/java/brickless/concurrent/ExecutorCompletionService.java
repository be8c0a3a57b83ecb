package brickless.concurrent;

import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletionService;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RunnableFuture;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.ExecutorCompletionService} on virtual monitors. */
public class ExecutorCompletionService<V> implements CompletionService<V> {
    private final Executor executor;
    private final BlockingQueue<Future<V>> completed;

    /** Creates a service that runs tasks on {@code executor}. */
    public ExecutorCompletionService(Executor executor) {
        this(executor, new LinkedBlockingQueue<>());
    }

    /** Creates a service that puts completed tasks into {@code completionQueue}. */
    public ExecutorCompletionService(Executor executor, BlockingQueue<Future<V>> completionQueue) {
        this.executor = Objects.requireNonNull(executor);
        this.completed = Objects.requireNonNull(completionQueue);
    }

    @Override
    public Future<V> submit(Callable<V> task) {
        Objects.requireNonNull(task);
        return start(executor instanceof AbstractExecutorService
                ? ((AbstractExecutorService) executor).newTaskFor(task) : new FutureTask<>(task));
    }

    @Override
    public Future<V> submit(Runnable task, V result) {
        Objects.requireNonNull(task);
        return start(executor instanceof AbstractExecutorService
                ? ((AbstractExecutorService) executor).newTaskFor(task, result) : new FutureTask<>(task, result));
    }

    private Future<V> start(RunnableFuture<V> future) {
        executor.execute(new FutureTask<Void>(future, null) {
            @Override
            protected void done() {
                completed.add(future);
            }
        });
        return future;
    }

    @Override
    public Future<V> take() throws InterruptedException {
        return completed.take();
    }

    @Override
    public Future<V> poll() {
        return completed.poll();
    }

    @Override
    public Future<V> poll(long timeout, TimeUnit unit) throws InterruptedException {
        return completed.poll(timeout, unit);
    }
}
