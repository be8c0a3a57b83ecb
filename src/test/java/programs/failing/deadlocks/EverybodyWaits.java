package programs.failing.deadlocks;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.ReentrantLock;

/**
 * A lock that is never given back and a latch that nobody counts down: all wait, nobody can go on.
 *
 * @expected deadlock
 * @contains "main" WAITING
 * @contains "other" WAITING
 */
public class EverybodyWaits {
    public static void main(String[] args) throws InterruptedException {
        ReentrantLock lock = new ReentrantLock();
        CountDownLatch latch = new CountDownLatch(1);
        lock.lock();
        new Thread(() -> {
            lock.lock();
            latch.countDown();
        }, "other").start();
        latch.await();
    }
}
