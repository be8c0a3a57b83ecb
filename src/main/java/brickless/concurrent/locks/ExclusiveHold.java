package brickless.concurrent.locks;

import brickless.kernel.hooks.OwnedLock;
import java.util.Collection;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/** Who holds an exclusive, re-entrant lock and how often. Every field is guarded by the monitor of the waiting line. */
final class ExclusiveHold implements MonitorCondition.Owner, OwnedLock {
    private final WaitingLine line;
    private final BooleanSupplier available;
    private Thread owner;
    private int holds;

    /** Nobody takes the lock while {@code available}, asked with the line's monitor held, says no. */
    ExclusiveHold(WaitingLine line, BooleanSupplier available) {
        this.line = line;
        this.available = available;
    }

    Thread owner() {
        synchronized (line) {
            return owner;
        }
    }

    boolean mine() {
        return owner() == Thread.currentThread();
    }

    /** Holds of the current thread. */
    int count() {
        synchronized (line) {
            return mine() ? holds : 0;
        }
    }

    /** Takes the lock if it is free or already held by the current thread. */
    boolean take(int count) {
        synchronized (line) {
            Thread me = Thread.currentThread();
            if (owner != me && (owner != null || !available.getAsBoolean())) {
                return false;
            }
            int total = holds + count;
            if (total < 0) {
                throw new Error("Maximum lock count exceeded");
            }
            owner = me;
            holds = total;
            return true;
        }
    }

    /** Takes the lock once more, past everybody who waits, if the current thread holds it. */
    boolean takeAgain() {
        synchronized (line) {
            return mine() && take(1);
        }
    }

    /** Waits until the current thread holds the lock; an interrupt is kept for later. */
    void await(BooleanSupplier attempt) {
        LockSupport.setCurrentBlocker(this);
        try {
            line.passUninterruptibly(attempt);
        } finally {
            LockSupport.setCurrentBlocker(null);
        }
    }

    @Override
    public Thread lockOwner() {
        return owner;
    }

    void release(int count) {
        synchronized (line) {
            requireHeld();
            holds -= count;
            if (holds == 0) {
                owner = null;
                line.changed();
            }
        }
    }

    @Override
    public void requireHeld() {
        if (!mine()) {
            throw new IllegalMonitorStateException();
        }
    }

    @Override
    public int releaseFully() {
        synchronized (line) {
            requireHeld();
            int count = holds;
            release(count);
            return count;
        }
    }

    @Override
    public void retake(int count) {
        await(() -> take(count));
    }

    /** Threads waiting on a condition of this lock. */
    Collection<Thread> waitingThreads(Condition condition) {
        if (condition == null) {
            throw new NullPointerException();
        }
        if (!(condition instanceof MonitorCondition) || ((MonitorCondition) condition).lock() != this) {
            throw new IllegalArgumentException("not owner");
        }
        return ((MonitorCondition) condition).waitingThreads();
    }

    String describe() {
        Thread holder = owner();
        return holder == null ? "[Unlocked]" : "[Locked by thread " + holder.getName() + "]";
    }
}
