package brickless.concurrent.locks;

import java.util.ArrayList;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReadWriteLock;

/** {@code java.util.concurrent.locks.ReentrantReadWriteLock} on virtual monitors. */
public class ReentrantReadWriteLock implements ReadWriteLock {
    private final WaitingLine line;
    private final ExclusiveHold writing;
    /** Read holds of each thread that has any; guarded by the line. */
    private final Map<Thread, Integer> readHolds = new IdentityHashMap<>();
    /** Threads in the line that want to read; guarded by the line. */
    private final List<Thread> waitingReaders = new ArrayList<>();
    private final ReadLock readLock;
    private final WriteLock writeLock;

    /** Creates a lock that lets newcomers overtake. */
    public ReentrantReadWriteLock() {
        this(false);
    }

    /** Creates a lock; a fair one is granted in order of arrival. */
    public ReentrantReadWriteLock(boolean fair) {
        line = new WaitingLine(fair);
        writing = new ExclusiveHold(line, readHolds::isEmpty);
        readLock = new ReadLock(this);
        writeLock = new WriteLock(this);
    }

    @Override
    public ReadLock readLock() {
        return readLock;
    }

    @Override
    public WriteLock writeLock() {
        return writeLock;
    }

    /** Whether the lock is granted in order of arrival. */
    public final boolean isFair() {
        return line.isFair();
    }

    /** The thread that holds the write lock, or null. */
    protected Thread getOwner() {
        return writing.owner();
    }

    /** Number of read holds of all threads together. */
    public int getReadLockCount() {
        synchronized (line) {
            int count = 0;
            for (int holds : readHolds.values()) {
                count += holds;
            }
            return count;
        }
    }

    /** Number of read holds of the current thread. */
    public int getReadHoldCount() {
        synchronized (line) {
            return readHolds.getOrDefault(Thread.currentThread(), 0);
        }
    }

    /** Whether any thread holds the write lock. */
    public boolean isWriteLocked() {
        return writing.owner() != null;
    }

    /** Whether the current thread holds the write lock. */
    public boolean isWriteLockedByCurrentThread() {
        return writing.mine();
    }

    /** Number of write holds of the current thread. */
    public int getWriteHoldCount() {
        return writing.count();
    }

    /** Threads that wait for the write lock. */
    protected Collection<Thread> getQueuedWriterThreads() {
        synchronized (line) {
            List<Thread> threads = line.threads();
            threads.removeAll(waitingReaders);
            return threads;
        }
    }

    /** Threads that wait for the read lock. */
    protected Collection<Thread> getQueuedReaderThreads() {
        synchronized (line) {
            List<Thread> threads = line.threads();
            threads.retainAll(waitingReaders);
            return threads;
        }
    }

    /** Whether threads wait for the read or write lock. */
    public final boolean hasQueuedThreads() {
        return line.length() > 0;
    }

    /** Whether that thread waits for the read or write lock. */
    public final boolean hasQueuedThread(Thread thread) {
        return line.threads().contains(thread);
    }

    /** Number of threads that wait for the read or write lock. */
    public final int getQueueLength() {
        return line.length();
    }

    /** Threads that wait for the read or write lock. */
    protected Collection<Thread> getQueuedThreads() {
        return line.threads();
    }

    /** Whether threads wait on that condition of the write lock, which the current thread must hold. */
    public boolean hasWaiters(Condition condition) {
        return getWaitQueueLength(condition) > 0;
    }

    /** Number of threads that wait on that condition of the write lock, which the current thread must hold. */
    public int getWaitQueueLength(Condition condition) {
        return writing.waitingThreads(condition).size();
    }

    /** Threads that wait on that condition of the write lock, which the current thread must hold. */
    protected Collection<Thread> getWaitingThreads(Condition condition) {
        return writing.waitingThreads(condition);
    }

    @Override
    public String toString() {
        return super.toString() + "[Write locks = " + (isWriteLocked() ? 1 : 0) + ", Read locks = "
                + getReadLockCount() + "]";
    }

    private boolean takeRead() {
        synchronized (line) {
            if (writing.owner() != null && !writing.mine()) {
                return false;
            }
            readHolds.merge(Thread.currentThread(), 1, Integer::sum);
            return true;
        }
    }

    /**
     * A thread that reads or writes already may read (again) past everybody who waits: it would wait for itself
     * otherwise.
     */
    private boolean takeReadAgain() {
        synchronized (line) {
            return (getReadHoldCount() > 0 || writing.mine()) && takeRead();
        }
    }

    private void releaseRead() {
        synchronized (line) {
            Thread me = Thread.currentThread();
            Integer holds = readHolds.get(me);
            if (holds == null) {
                throw new IllegalMonitorStateException("attempt to unlock read lock, not locked by current thread");
            }
            if (holds > 1) {
                readHolds.put(me, holds - 1);
            } else {
                readHolds.remove(me);
                line.changed();
            }
        }
    }

    private boolean takeWrite() {
        return writing.take(1);
    }

    private boolean read(Deadline deadline) throws InterruptedException {
        Thread me = Thread.currentThread();
        synchronized (line) {
            waitingReaders.add(me);
            try {
                return line.pass(this::takeRead, deadline);
            } finally {
                waitingReaders.remove(me);
            }
        }
    }

    private void readUninterruptibly() {
        Thread me = Thread.currentThread();
        synchronized (line) {
            waitingReaders.add(me);
            try {
                writing.await(this::takeRead);
            } finally {
                waitingReaders.remove(me);
            }
        }
    }

    private static void failIfInterrupted() throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }

    /** The shared half. */
    public static class ReadLock implements Lock {
        private final ReentrantReadWriteLock both;

        /** Creates the read half of a lock. */
        protected ReadLock(ReentrantReadWriteLock lock) {
            both = lock;
        }

        @Override
        public void lock() {
            if (!both.takeReadAgain()) {
                both.readUninterruptibly();
            }
        }

        @Override
        public void lockInterruptibly() throws InterruptedException {
            lock(Deadline.NEVER);
        }

        @Override
        public boolean tryLock() {
            return both.takeRead();
        }

        @Override
        public boolean tryLock(long timeout, TimeUnit unit) throws InterruptedException {
            return lock(Deadline.after(timeout, unit));
        }

        private boolean lock(Deadline deadline) throws InterruptedException {
            failIfInterrupted();
            return both.takeReadAgain() || both.read(deadline);
        }

        @Override
        public void unlock() {
            both.releaseRead();
        }

        /** Read locks have no conditions: throws UnsupportedOperationException. */
        @Override
        public Condition newCondition() {
            throw new UnsupportedOperationException("a read lock has no conditions");
        }

        @Override
        public String toString() {
            return super.toString() + "[Read locks = " + both.getReadLockCount() + "]";
        }
    }

    /** The exclusive half. */
    public static class WriteLock implements Lock {
        private final ReentrantReadWriteLock both;

        /** Creates the write half of a lock. */
        protected WriteLock(ReentrantReadWriteLock lock) {
            both = lock;
        }

        @Override
        public void lock() {
            if (!both.writing.takeAgain()) {
                both.writing.await(both::takeWrite);
            }
        }

        @Override
        public void lockInterruptibly() throws InterruptedException {
            lock(Deadline.NEVER);
        }

        @Override
        public boolean tryLock() {
            return both.takeWrite();
        }

        @Override
        public boolean tryLock(long timeout, TimeUnit unit) throws InterruptedException {
            return lock(Deadline.after(timeout, unit));
        }

        private boolean lock(Deadline deadline) throws InterruptedException {
            failIfInterrupted();
            return both.writing.takeAgain() || both.line.pass(both::takeWrite, deadline);
        }

        @Override
        public void unlock() {
            both.writing.release(1);
        }

        @Override
        public Condition newCondition() {
            return new MonitorCondition(both.writing);
        }

        /** Whether the current thread holds the write lock. */
        public boolean isHeldByCurrentThread() {
            return both.writing.mine();
        }

        /** Number of write holds of the current thread. */
        public int getHoldCount() {
            return both.writing.count();
        }

        @Override
        public String toString() {
            return super.toString() + both.writing.describe();
        }
    }
}
