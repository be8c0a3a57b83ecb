package programs.failing.deadlocks;

import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;

/**
 * Two threads take a ReentrantLock and the lock of a writer in opposite order, while a third goes on.
 *
 * @expected deadlock
 * @contains "one" WAITING for a lock held by "two" at
 * @contains "two" WAITING for a lock held by "one" at
 * @contains at programs.failing.deadlocks.LocksOfTheJdk.take(LocksOfTheJdk.java:31)
 */
public class LocksOfTheJdk {
    private static volatile int work;

    public static void main(String[] args) {
        Lock plain = new ReentrantLock();
        Lock writing = new ReentrantReadWriteLock().writeLock();
        new Thread(() -> take(plain, writing), "one").start();
        new Thread(() -> take(writing, plain), "two").start();
        while (true) {
            work++;
        }
    }

    private static void take(Lock first, Lock second) {
        first.lock();
        pause();
        second.lock();
        System.out.println("both");
    }

    private static void pause() {
        try {
            Thread.sleep(50);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
