package brickless.concurrent.locks;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.function.BooleanSupplier;

/**
 * {@code java.util.concurrent.locks.StampedLock} on virtual monitors. A stamp is the number of times that the lock was
 * taken for writing, and in its two lowest bits the mode.
 */
public class StampedLock {
    private static final int MODE_BITS = 2;
    private static final long MODE_MASK = 3;
    private static final long OPTIMISTIC = 1;
    private static final long READ = 2;
    private static final long WRITE = 3;

    private final WaitingLine line = new WaitingLine(false);
    // Guarded by the line:
    private long version = 1;
    private boolean writing;
    private int readers;

    /** Creates a lock that nobody holds. */
    public StampedLock() {
    }

    private long stamp(long mode) {
        return version << MODE_BITS | mode;
    }

    private boolean takeWrite() {
        synchronized (line) {
            if (writing || readers > 0) {
                return false;
            }
            writing = true;
            version++;
            return true;
        }
    }

    private boolean takeRead() {
        synchronized (line) {
            if (writing) {
                return false;
            }
            readers++;
            return true;
        }
    }

    /** Waits for the write lock. */
    public long writeLock() {
        return lock(this::takeWrite, WRITE);
    }

    /** Takes the write lock if it is free; 0 if not. */
    public long tryWriteLock() {
        return tryLock(this::takeWrite, WRITE);
    }

    /** Waits at most that long for the write lock; 0 if the time passed. */
    public long tryWriteLock(long time, TimeUnit unit) throws InterruptedException {
        return lock(this::takeWrite, WRITE, Deadline.after(time, unit));
    }

    /** Waits for the write lock. */
    public long writeLockInterruptibly() throws InterruptedException {
        return lock(this::takeWrite, WRITE, Deadline.NEVER);
    }

    /** Waits for the read lock. */
    public long readLock() {
        return lock(this::takeRead, READ);
    }

    /** Takes the read lock if nobody writes; 0 if not. */
    public long tryReadLock() {
        return tryLock(this::takeRead, READ);
    }

    /** Waits at most that long for the read lock; 0 if the time passed. */
    public long tryReadLock(long time, TimeUnit unit) throws InterruptedException {
        return lock(this::takeRead, READ, Deadline.after(time, unit));
    }

    /** Waits for the read lock. */
    public long readLockInterruptibly() throws InterruptedException {
        return lock(this::takeRead, READ, Deadline.NEVER);
    }

    private long lock(BooleanSupplier take, long mode) {
        synchronized (line) {
            line.passUninterruptibly(take);
            return stamp(mode);
        }
    }

    private long tryLock(BooleanSupplier take, long mode) {
        synchronized (line) {
            return take.getAsBoolean() ? stamp(mode) : 0;
        }
    }

    private long lock(BooleanSupplier take, long mode, Deadline deadline) throws InterruptedException {
        synchronized (line) {
            return line.pass(take, deadline) ? stamp(mode) : 0;
        }
    }

    /** A stamp to be validated later; 0 while somebody writes. */
    public long tryOptimisticRead() {
        synchronized (line) {
            return writing ? 0 : stamp(OPTIMISTIC);
        }
    }

    /** Whether nobody has taken the write lock since the stamp was made. */
    public boolean validate(long stamp) {
        synchronized (line) {
            return stamp != 0 && stamp >>> MODE_BITS == version && (!writing || isWriteLockStamp(stamp));
        }
    }

    /** Releases the write lock; IllegalMonitorStateException if the stamp is not its. */
    public void unlockWrite(long stamp) {
        synchronized (line) {
            requireHeld(holdsWrite(stamp));
            writing = false;
            version++;
            line.changed();
        }
    }

    /** Releases a read lock; IllegalMonitorStateException if the stamp is not one's. */
    public void unlockRead(long stamp) {
        synchronized (line) {
            requireHeld(holdsRead(stamp));
            readers--;
            line.changed();
        }
    }

    /** Releases what the stamp stands for. */
    public void unlock(long stamp) {
        if (isWriteLockStamp(stamp)) {
            unlockWrite(stamp);
        } else {
            unlockRead(stamp);
        }
    }

    private boolean holdsWrite(long stamp) {
        return writing && stamp == stamp(WRITE);
    }

    private boolean holdsRead(long stamp) {
        return readers > 0 && stamp == stamp(READ);
    }

    private static void requireHeld(boolean held) {
        if (!held) {
            throw new IllegalMonitorStateException();
        }
    }

    /** A write stamp instead of {@code stamp} if that is possible at once, else 0. */
    public long tryConvertToWriteLock(long stamp) {
        synchronized (line) {
            if (holdsWrite(stamp)) {
                return stamp;
            }
            if (holdsRead(stamp) && readers == 1) {
                readers = 0;
                return tryWriteLock();
            }
            return isOptimisticReadStamp(stamp) && validate(stamp) ? tryWriteLock() : 0;
        }
    }

    /** A read stamp instead of {@code stamp} if that is possible at once, else 0. */
    public long tryConvertToReadLock(long stamp) {
        synchronized (line) {
            if (holdsRead(stamp)) {
                return stamp;
            }
            if (holdsWrite(stamp)) {
                unlockWrite(stamp);
                return tryReadLock();
            }
            return isOptimisticReadStamp(stamp) && validate(stamp) ? tryReadLock() : 0;
        }
    }

    /** An optimistic stamp instead of {@code stamp}, whose lock is released; 0 if the stamp is not valid. */
    public long tryConvertToOptimisticRead(long stamp) {
        synchronized (line) {
            if (holdsWrite(stamp) || holdsRead(stamp)) {
                unlock(stamp);
                return stamp(OPTIMISTIC);
            }
            return isOptimisticReadStamp(stamp) && validate(stamp) ? stamp : 0;
        }
    }

    /** Releases the write lock, whoever holds it; false if nobody does. */
    public boolean tryUnlockWrite() {
        synchronized (line) {
            if (writing) {
                unlockWrite(stamp(WRITE));
                return true;
            }
            return false;
        }
    }

    /** Releases one read lock, whoever holds it; false if nobody does. */
    public boolean tryUnlockRead() {
        synchronized (line) {
            if (readers > 0) {
                unlockRead(stamp(READ));
                return true;
            }
            return false;
        }
    }

    /** Whether somebody holds the write lock. */
    public boolean isWriteLocked() {
        synchronized (line) {
            return writing;
        }
    }

    /** Whether somebody holds a read lock. */
    public boolean isReadLocked() {
        return getReadLockCount() > 0;
    }

    /** Number of read locks. */
    public int getReadLockCount() {
        synchronized (line) {
            return readers;
        }
    }

    /** Whether the stamp stands for the write lock. */
    public static boolean isWriteLockStamp(long stamp) {
        return (stamp & MODE_MASK) == WRITE;
    }

    /** Whether the stamp stands for a read lock. */
    public static boolean isReadLockStamp(long stamp) {
        return (stamp & MODE_MASK) == READ;
    }

    /** Whether the stamp stands for a lock. */
    public static boolean isLockStamp(long stamp) {
        return isWriteLockStamp(stamp) || isReadLockStamp(stamp);
    }

    /** Whether the stamp is an optimistic one. */
    public static boolean isOptimisticReadStamp(long stamp) {
        return (stamp & MODE_MASK) == OPTIMISTIC;
    }

    /** The read lock as a Lock without conditions. */
    public Lock asReadLock() {
        return new View(READ);
    }

    /** The write lock as a Lock without conditions. */
    public Lock asWriteLock() {
        return new View(WRITE);
    }

    /** Both locks. */
    public ReadWriteLock asReadWriteLock() {
        return new ReadWriteLock() {
            @Override
            public Lock readLock() {
                return asReadLock();
            }

            @Override
            public Lock writeLock() {
                return asWriteLock();
            }
        };
    }

    @Override
    public String toString() {
        synchronized (line) {
            String state = writing ? "[Write-locked]" : readers > 0 ? "[Read-locks:" + readers + "]" : "[Unlocked]";
            return super.toString() + state;
        }
    }

    /** One mode of the lock. */
    private final class View implements Lock {
        private final long mode;
        private final BooleanSupplier take;

        View(long mode) {
            this.mode = mode;
            this.take = mode == WRITE ? StampedLock.this::takeWrite : StampedLock.this::takeRead;
        }

        @Override
        public void lock() {
            StampedLock.this.lock(take, mode);
        }

        @Override
        public void lockInterruptibly() throws InterruptedException {
            StampedLock.this.lock(take, mode, Deadline.NEVER);
        }

        @Override
        public boolean tryLock() {
            return take.getAsBoolean();
        }

        @Override
        public boolean tryLock(long time, TimeUnit unit) throws InterruptedException {
            return StampedLock.this.lock(take, mode, Deadline.after(time, unit)) != 0;
        }

        @Override
        public void unlock() {
            requireHeld(mode == WRITE ? tryUnlockWrite() : tryUnlockRead());
        }

        /** Throws UnsupportedOperationException. */
        @Override
        public Condition newCondition() {
            throw new UnsupportedOperationException("a stamped lock has no conditions");
        }
    }
}
