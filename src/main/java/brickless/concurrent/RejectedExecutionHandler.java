package brickless.concurrent;

/** {@code java.util.concurrent.RejectedExecutionHandler}, which names {@link ThreadPoolExecutor} in its signature. */
public interface RejectedExecutionHandler {
    /**
     * Called by {@link ThreadPoolExecutor#execute} for a task that it cannot accept; may throw
     * RejectedExecutionException.
     */
    void rejectedExecution(Runnable r, ThreadPoolExecutor executor);
}
