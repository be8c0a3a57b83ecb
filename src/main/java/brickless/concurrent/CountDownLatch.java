package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.CountDownLatch} on virtual monitors. */
public class CountDownLatch {
    private final Object monitor = new Object();
    private long count;

    /**
     * Creates a latch that opens after {@code count} calls of {@link #countDown}; IllegalArgumentException if negative.
     */
    public CountDownLatch(int count) {
        if (count < 0) {
            throw new IllegalArgumentException("count < 0");
        }
        this.count = count;
    }

    /** Waits until the latch is open. */
    public void await() throws InterruptedException {
        await(Deadline.NEVER);
    }

    /** Waits until the latch is open; false if the time passed first. */
    public boolean await(long timeout, TimeUnit unit) throws InterruptedException {
        return await(Deadline.after(timeout, unit));
    }

    private boolean await(Deadline deadline) throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        synchronized (monitor) {
            while (count > 0) {
                if (!deadline.await(monitor)) {
                    return false;
                }
            }
            return true;
        }
    }

    /** Counts down once; no effect on an open latch. */
    public void countDown() {
        synchronized (monitor) {
            if (count > 0) {
                count--;
                if (count == 0) {
                    monitor.notifyAll();
                }
            }
        }
    }

    /** What is left to count down. */
    public long getCount() {
        synchronized (monitor) {
            return count;
        }
    }

    @Override
    public String toString() {
        return super.toString() + "[Count = " + getCount() + "]";
    }
}
