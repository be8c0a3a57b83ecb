package brickless.concurrent.locks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class ReadWriteLocksTest {
    private final ReentrantReadWriteLock lock = new ReentrantReadWriteLock();
    private final StampedLock stamped = new StampedLock();

    private static boolean takenElsewhere(Lock wanted) throws InterruptedException {
        boolean[] taken = new boolean[1];
        Waiting.started(() -> {
            taken[0] = wanted.tryLock(1, TimeUnit.MILLISECONDS);
            if (taken[0]) {
                wanted.unlock();
            }
        }).ends();
        return taken[0];
    }

    @Test
    void readersShareAndKeepWritersOut() throws InterruptedException {
        lock.readLock().lock();
        lock.readLock().lock();
        assertThat(takenElsewhere(lock.readLock())).isTrue();
        assertThat(takenElsewhere(lock.writeLock())).isFalse();
        assertThat(lock.getReadHoldCount()).isEqualTo(2);
        assertThat(lock.toString()).endsWith("[Write locks = 0, Read locks = 2]");
        lock.readLock().unlock();
        lock.readLock().unlock();
        assertThat(takenElsewhere(lock.writeLock())).isTrue();
    }

    @Test
    void writerKeepsEverybodyOutButMayReadAndDowngrade() throws InterruptedException {
        lock.writeLock().lock();
        assertThat(takenElsewhere(lock.readLock())).isFalse();
        assertThat(takenElsewhere(lock.writeLock())).isFalse();
        lock.readLock().lock();
        lock.writeLock().unlock();
        assertThat(lock.isWriteLocked()).isFalse();
        assertThat(takenElsewhere(lock.readLock())).isTrue();
        assertThat(takenElsewhere(lock.writeLock())).isFalse();
    }

    @Test
    void readerMayReadAgainAlthoughAWriterWaits() throws InterruptedException {
        ReentrantReadWriteLock fair = new ReentrantReadWriteLock(true);
        fair.readLock().lock();
        Waiting writer = Waiting.in(fair.writeLock()::lock);
        assertThat(fair.getQueuedWriterThreads()).containsExactly(writer.thread());
        Waiting reader = Waiting.in(() -> {
            fair.readLock().lock();
            fair.readLock().unlock();
        });
        assertThat(fair.getQueuedReaderThreads()).containsExactly(reader.thread());
        fair.readLock().lock();
        fair.readLock().unlock();
        reader.interrupted();
        fair.readLock().unlock();
        writer.ends();
        assertThat(fair.getOwner()).isEqualTo(writer.thread());
    }

    @Test
    void upgradeIsNotPossible() {
        lock.readLock().lock();
        assertThat(lock.writeLock().tryLock()).isFalse();
    }

    @Test
    void whoDoesNotHoldCannotUnlock() {
        assertThatThrownBy(lock.readLock()::unlock).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(lock.writeLock()::unlock).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(lock.readLock()::newCondition).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void conditionOfTheWriteLockWaitsForReadersBeforeItGoesOn() throws InterruptedException {
        Condition condition = lock.writeLock().newCondition();
        int[] readersSeen = {-1};
        Waiting writer = Waiting.in(() -> {
            lock.writeLock().lock();
            condition.await();
            readersSeen[0] = lock.getReadLockCount();
            lock.writeLock().unlock();
        });
        lock.writeLock().lock();
        lock.readLock().lock();
        condition.signal();
        lock.writeLock().unlock();
        while (!lock.hasQueuedThread(writer.thread())) {
            Thread.onSpinWait();
        }
        lock.readLock().unlock();
        writer.ends();
        assertThat(readersSeen[0]).isZero();
    }

    @Test
    void optimisticStampIsValidUntilSomebodyWrites() {
        long stamp = stamped.tryOptimisticRead();
        long read = stamped.readLock();
        assertThat(stamped.validate(stamp)).isTrue();
        stamped.unlockRead(read);
        long write = stamped.writeLock();
        assertThat(stamped.validate(stamp)).isFalse();
        assertThat(stamped.validate(write)).isTrue();
        assertThat(stamped.tryOptimisticRead()).isZero();
        stamped.unlockWrite(write);
        assertThat(stamped.validate(stamp)).isFalse();
        assertThat(stamped.validate(0)).isFalse();
    }

    @Test
    void stampsConvertWhereNobodyIsInTheWay() {
        long read = stamped.readLock();
        long write = stamped.tryConvertToWriteLock(read);
        assertThat(StampedLock.isWriteLockStamp(write)).isTrue();
        long again = stamped.tryConvertToReadLock(write);
        assertThat(StampedLock.isReadLockStamp(again)).isTrue();
        long second = stamped.readLock();
        assertThat(stamped.tryConvertToWriteLock(second)).isZero();
        assertThat(stamped.getReadLockCount()).isEqualTo(2);
        long optimistic = stamped.tryConvertToOptimisticRead(second);
        assertThat(StampedLock.isOptimisticReadStamp(optimistic)).isTrue();
        assertThat(stamped.getReadLockCount()).isEqualTo(1);
    }

    @Test
    void wrongStampsAreRefused() {
        long read = stamped.readLock();
        assertThatThrownBy(() -> stamped.unlockWrite(read)).isInstanceOf(IllegalMonitorStateException.class);
        stamped.unlock(read);
        assertThatThrownBy(() -> stamped.unlock(read)).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(stamped.asWriteLock()::unlock).isInstanceOf(IllegalMonitorStateException.class);
    }

    @Test
    void stampedWriterWaitsForReadersAndIsNotReentrant() throws InterruptedException {
        long read = stamped.readLock();
        assertThat(stamped.tryWriteLock()).isZero();
        assertThat(stamped.tryWriteLock(1, TimeUnit.MILLISECONDS)).isZero();
        Waiting writer = Waiting.in(() -> stamped.unlockWrite(stamped.writeLock()));
        stamped.unlockRead(read);
        writer.ends();
        stamped.asWriteLock().lock();
        assertThat(stamped.asWriteLock().tryLock()).isFalse();
        assertThat(stamped.asReadWriteLock().readLock().tryLock()).isFalse();
        assertThat(stamped.tryUnlockWrite()).isTrue();
        assertThat(stamped.toString()).endsWith("[Unlocked]");
    }
}
