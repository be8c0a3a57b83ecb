package programs.passing.concurrency;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Everything that can wait for a limited time gives up.
 *
 * @expected exited 0
 * @prints lock false
 * @prints semaphore false
 * @prints latch false
 * @prints poll null
 * @prints offer false
 * @prints future timed out
 * @prints condition false
 */
public class TimeOuts {
    /** The program. */
    public static void main(String[] args) throws Exception {
        ReentrantLock lock = new ReentrantLock();
        lock.lock();
        Thread other = new Thread(() -> {
            try {
                System.out.println("lock " + lock.tryLock(20, TimeUnit.MILLISECONDS));
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        other.start();
        other.join();
        System.out.println("semaphore " + new Semaphore(0).tryAcquire(20, TimeUnit.MILLISECONDS));
        System.out.println("latch " + new CountDownLatch(1).await(20, TimeUnit.MILLISECONDS));
        ArrayBlockingQueue<String> queue = new ArrayBlockingQueue<>(1);
        System.out.println("poll " + queue.poll(20, TimeUnit.MILLISECONDS));
        queue.add("full");
        System.out.println("offer " + queue.offer("more", 20, TimeUnit.MILLISECONDS));
        try {
            new FutureTask<>(() -> 1).get(20, TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            System.out.println("future timed out");
        }
        System.out.println("condition " + lock.newCondition().await(20, TimeUnit.MILLISECONDS));
    }
}
