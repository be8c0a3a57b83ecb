package programs.passing.concurrency;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * A pool that is full rejects, runs in the caller, or discards.
 *
 * @expected exited 0
 * @prints aborted
 * @prints caller runs on main
 * @prints ran first
 * @prints ran second
 * @prints completed 2
 * @prints uncaught boom
 * @prints next runs
 */
public class PoolPolicies {
    /** The program. */
    public static void main(String[] args) throws Exception {
        CountDownLatch gate = new CountDownLatch(1);
        ThreadPoolExecutor pool = new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new ArrayBlockingQueue<>(1));
        pool.execute(() -> {
            try {
                gate.await();
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
            System.out.println("ran first");
        });
        pool.execute(() -> System.out.println("ran second"));
        try {
            pool.execute(() -> System.out.println("never"));
        } catch (RejectedExecutionException e) {
            System.out.println("aborted");
        }
        pool.setRejectedExecutionHandler(new ThreadPoolExecutor.CallerRunsPolicy());
        pool.execute(() -> System.out.println("caller runs on " + Thread.currentThread().getName()));
        gate.countDown();
        pool.shutdown();
        pool.awaitTermination(10, TimeUnit.SECONDS);
        System.out.println("completed " + pool.getCompletedTaskCount());
        CountDownLatch died = new CountDownLatch(1);
        ThreadPoolExecutor fragile =
                new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new ArrayBlockingQueue<>(2), work -> {
            Thread thread = new Thread(work);
            thread.setUncaughtExceptionHandler((t, e) -> {
                System.out.println("uncaught " + e.getMessage());
                died.countDown();
            });
            return thread;
        });
        fragile.execute(() -> {
            throw new IllegalStateException("boom");
        });
        died.await();
        fragile.execute(() -> System.out.println("next runs"));
        fragile.shutdown();
        fragile.awaitTermination(10, TimeUnit.SECONDS);
    }
}
