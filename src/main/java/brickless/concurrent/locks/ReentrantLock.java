package brickless.concurrent.locks;

import java.util.Collection;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;

/** {@code java.util.concurrent.locks.ReentrantLock} on virtual monitors. */
public class ReentrantLock implements Lock {
    private final WaitingLine line;
    private final ExclusiveHold hold;

    /** Creates a lock that lets newcomers overtake. */
    public ReentrantLock() {
        this(false);
    }

    /** Creates a lock; a fair one is granted in order of arrival. */
    public ReentrantLock(boolean fair) {
        line = new WaitingLine(fair);
        hold = new ExclusiveHold(line, () -> true);
    }

    @Override
    public void lock() {
        if (!hold.takeAgain()) {
            hold.await(() -> hold.take(1));
        }
    }

    @Override
    public void lockInterruptibly() throws InterruptedException {
        lock(Deadline.NEVER);
    }

    @Override
    public boolean tryLock() {
        return hold.take(1);
    }

    @Override
    public boolean tryLock(long timeout, TimeUnit unit) throws InterruptedException {
        return lock(Deadline.after(timeout, unit));
    }

    private boolean lock(Deadline deadline) throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        return hold.takeAgain() || line.pass(() -> hold.take(1), deadline);
    }

    @Override
    public void unlock() {
        hold.release(1);
    }

    @Override
    public Condition newCondition() {
        return new MonitorCondition(hold);
    }

    /** Number of holds of the current thread. */
    public int getHoldCount() {
        return hold.count();
    }

    /** Whether the current thread holds the lock. */
    public boolean isHeldByCurrentThread() {
        return hold.mine();
    }

    /** Whether any thread holds the lock. */
    public boolean isLocked() {
        return hold.owner() != null;
    }

    /** Whether the lock is granted in order of arrival. */
    public final boolean isFair() {
        return line.isFair();
    }

    /** The holding thread, or null. */
    protected Thread getOwner() {
        return hold.owner();
    }

    /** Whether threads wait for the lock. */
    public final boolean hasQueuedThreads() {
        return line.length() > 0;
    }

    /** Whether that thread waits for the lock. */
    public final boolean hasQueuedThread(Thread thread) {
        return line.threads().contains(thread);
    }

    /** Number of threads that wait for the lock. */
    public final int getQueueLength() {
        return line.length();
    }

    /** Threads that wait for the lock. */
    protected Collection<Thread> getQueuedThreads() {
        return line.threads();
    }

    /** Whether threads wait on that condition of this lock, which the current thread must hold. */
    public boolean hasWaiters(Condition condition) {
        return getWaitQueueLength(condition) > 0;
    }

    /** Number of threads that wait on that condition of this lock, which the current thread must hold. */
    public int getWaitQueueLength(Condition condition) {
        return hold.waitingThreads(condition).size();
    }

    /** Threads that wait on that condition of this lock, which the current thread must hold. */
    protected Collection<Thread> getWaitingThreads(Condition condition) {
        return hold.waitingThreads(condition);
    }

    @Override
    public String toString() {
        return super.toString() + hold.describe();
    }
}
