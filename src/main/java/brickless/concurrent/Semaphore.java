package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import brickless.concurrent.locks.WaitingLine;
import java.util.Collection;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.Semaphore} on virtual monitors. */
public class Semaphore {
    private final WaitingLine line;
    /** Guarded by the line. */
    private int permits;

    /** Creates a semaphore that lets newcomers overtake; {@code permits} may be negative. */
    public Semaphore(int permits) {
        this(permits, false);
    }

    /** Creates a semaphore; a fair one is granted in order of arrival. */
    public Semaphore(int permits, boolean fair) {
        this.permits = permits;
        this.line = new WaitingLine(fair);
    }

    /** Takes one permit, waiting for it. */
    public void acquire() throws InterruptedException {
        acquire(1);
    }

    /** Takes {@code permits} at once, waiting for them. */
    public void acquire(int permits) throws InterruptedException {
        requireNotNegative(permits);
        line.pass(() -> take(permits), Deadline.NEVER);
    }

    /** Takes one permit, waiting for it even when interrupted. */
    public void acquireUninterruptibly() {
        acquireUninterruptibly(1);
    }

    /** Takes {@code permits} at once, waiting for them even when interrupted. */
    public void acquireUninterruptibly(int permits) {
        requireNotNegative(permits);
        line.passUninterruptibly(() -> take(permits));
    }

    /** Takes one permit if there is one now, past everybody who waits. */
    public boolean tryAcquire() {
        return tryAcquire(1);
    }

    /** Takes {@code permits} if there are as many now, past everybody who waits. */
    public boolean tryAcquire(int permits) {
        requireNotNegative(permits);
        return take(permits);
    }

    /** Takes one permit, waiting at most that long. */
    public boolean tryAcquire(long timeout, TimeUnit unit) throws InterruptedException {
        return tryAcquire(1, timeout, unit);
    }

    /** Takes {@code permits} at once, waiting at most that long. */
    public boolean tryAcquire(int permits, long timeout, TimeUnit unit) throws InterruptedException {
        requireNotNegative(permits);
        return line.pass(() -> take(permits), Deadline.after(timeout, unit));
    }

    /** Gives one permit back. */
    public void release() {
        release(1);
    }

    /** Gives {@code permits} back; Error if their number overflows. */
    public void release(int permits) {
        requireNotNegative(permits);
        synchronized (line) {
            int total = this.permits + permits;
            if (total < this.permits) {
                throw new Error("Maximum permit count exceeded");
            }
            this.permits = total;
            line.changed();
        }
    }

    /** Number of permits. */
    public int availablePermits() {
        synchronized (line) {
            return permits;
        }
    }

    /** Takes all permits and returns their number (negative if there were fewer than none). */
    public int drainPermits() {
        synchronized (line) {
            int drained = permits;
            permits = 0;
            return drained;
        }
    }

    /** Takes permits away without waiting; their number may become negative. */
    protected void reducePermits(int reduction) {
        requireNotNegative(reduction);
        synchronized (line) {
            int total = permits - reduction;
            if (total > permits) {
                throw new Error("Permit count underflow");
            }
            permits = total;
        }
    }

    /** Whether permits are granted in order of arrival. */
    public boolean isFair() {
        return line.isFair();
    }

    /** Whether threads wait for permits. */
    public final boolean hasQueuedThreads() {
        return line.length() > 0;
    }

    /** Number of threads that wait for permits. */
    public final int getQueueLength() {
        return line.length();
    }

    /** Threads that wait for permits. */
    protected Collection<Thread> getQueuedThreads() {
        return line.threads();
    }

    @Override
    public String toString() {
        return super.toString() + "[Permits = " + availablePermits() + "]";
    }

    private boolean take(int wanted) {
        synchronized (line) {
            if (permits < wanted) {
                return false;
            }
            permits -= wanted;
            return true;
        }
    }

    private static void requireNotNegative(int permits) {
        if (permits < 0) {
            throw new IllegalArgumentException("negative number of permits");
        }
    }
}
