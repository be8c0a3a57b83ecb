package brickless.concurrent.locks;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Date;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;

/** A condition of an exclusive lock: each waiter has a monitor of its own, signals go to the longest waiting one. */
final class MonitorCondition implements Condition {
    /** What a condition needs from its lock. */
    interface Owner {
        /** Throws IllegalMonitorStateException unless the current thread holds the lock. */
        void requireHeld();

        /** Releases every hold of the current thread and returns their number. */
        int releaseFully();

        /** Takes the lock again, however long that takes, with that number of holds. */
        void retake(int holds);
    }

    /** One waiting thread; its fields are guarded by its own monitor. */
    private static final class Waiter {
        final Thread thread = Thread.currentThread();
        boolean signalled;
        boolean gaveUp;
    }

    private final Owner lock;
    /** Guarded by the lock: only its holder touches the list. */
    private final Deque<Waiter> waiters = new ArrayDeque<>();

    MonitorCondition(Owner lock) {
        this.lock = lock;
    }

    Owner lock() {
        return lock;
    }

    List<Thread> waitingThreads() {
        lock.requireHeld();
        List<Thread> threads = new ArrayList<>();
        for (Waiter waiter : waiters) {
            synchronized (waiter) {
                if (!waiter.gaveUp) {
                    threads.add(waiter.thread);
                }
            }
        }
        return threads;
    }

    @Override
    public void await() throws InterruptedException {
        await(Deadline.NEVER);
    }

    @Override
    public long awaitNanos(long nanosTimeout) throws InterruptedException {
        Deadline deadline = Deadline.after(nanosTimeout);
        await(deadline);
        return deadline.nanosLeft();
    }

    @Override
    public boolean await(long time, TimeUnit unit) throws InterruptedException {
        return await(Deadline.after(time, unit));
    }

    @Override
    public boolean awaitUntil(Date deadline) throws InterruptedException {
        return await(deadline.getTime() - System.currentTimeMillis(), TimeUnit.MILLISECONDS);
    }

    @Override
    public void awaitUninterruptibly() {
        Waiter waiter = enqueue();
        int holds = lock.releaseFully();
        boolean interrupted = false;
        try {
            synchronized (waiter) {
                while (!waiter.signalled) {
                    try {
                        waiter.wait();
                    } catch (InterruptedException e) {
                        interrupted = true;
                    }
                }
            }
        } finally {
            lock.retake(holds);
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private boolean await(Deadline deadline) throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        Waiter waiter = enqueue();
        int holds = lock.releaseFully();
        try {
            return awaitSignal(waiter, deadline);
        } finally {
            lock.retake(holds);
            waiters.remove(waiter);
        }
    }

    private Waiter enqueue() {
        lock.requireHeld();
        Waiter waiter = new Waiter();
        waiters.addLast(waiter);
        return waiter;
    }

    private static boolean awaitSignal(Waiter waiter, Deadline deadline) throws InterruptedException {
        synchronized (waiter) {
            try {
                while (!waiter.signalled && deadline.await(waiter)) {
                    continue;
                }
            } catch (InterruptedException e) {
                if (!waiter.signalled) {
                    waiter.gaveUp = true;
                    throw e;
                }
                // Signalled first, interrupted second: the signal must not be lost, the interrupt neither.
                Thread.currentThread().interrupt();
            }
            waiter.gaveUp = !waiter.signalled;
            return waiter.signalled;
        }
    }

    @Override
    public void signal() {
        lock.requireHeld();
        boolean delivered = false;
        while (!delivered && !waiters.isEmpty()) {
            delivered = deliver(waiters.pollFirst());
        }
    }

    @Override
    public void signalAll() {
        lock.requireHeld();
        while (!waiters.isEmpty()) {
            deliver(waiters.pollFirst());
        }
    }

    private static boolean deliver(Waiter waiter) {
        synchronized (waiter) {
            if (waiter.gaveUp) {
                return false;
            }
            waiter.signalled = true;
            waiter.notifyAll();
            return true;
        }
    }
}
