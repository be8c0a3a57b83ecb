package programs.passing.concurrency;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.locks.ReentrantLock;

/**
 * An interrupt ends every kind of waiting that can be interrupted.
 *
 * @expected exited 0
 * @prints sleep interrupted
 * @prints take interrupted
 * @prints lock interrupted
 * @prints condition interrupted
 * @prints latch interrupted
 * @prints semaphore interrupted
 * @prints future cancelled
 */
public class Interruptions {
    private interface Waiting {
        void run() throws InterruptedException;
    }

    private static void interrupt(String name, Waiting waiting) throws InterruptedException {
        Thread thread = new Thread(() -> {
            try {
                waiting.run();
                System.out.println(name + " ended");
            } catch (InterruptedException e) {
                System.out.println(name + " interrupted");
            }
        });
        thread.start();
        Thread.sleep(10);
        thread.interrupt();
        thread.join();
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        ReentrantLock held = new ReentrantLock();
        held.lock();
        ReentrantLock free = new ReentrantLock();
        interrupt("sleep", () -> Thread.sleep(100000));
        interrupt("take", () -> new LinkedBlockingQueue<String>().take());
        interrupt("lock", held::lockInterruptibly);
        interrupt("condition", () -> {
            free.lock();
            try {
                free.newCondition().await();
            } finally {
                free.unlock();
            }
        });
        interrupt("latch", () -> new CountDownLatch(1).await());
        interrupt("semaphore", () -> new Semaphore(0).acquire());
        ExecutorService pool = Executors.newSingleThreadExecutor();
        Future<?> future = pool.submit(() -> {
            Thread.sleep(100000);
            return null;
        });
        future.cancel(true);
        try {
            future.get();
        } catch (CancellationException e) {
            System.out.println("future cancelled");
        }
        pool.shutdown();
    }
}
