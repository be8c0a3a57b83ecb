package brickless.concurrent.locks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Date;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(30)
class ReentrantLockTest {
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition condition = lock.newCondition();

    @Test
    void holderMayLockAgainAndMustUnlockAsOften() {
        lock.lock();
        lock.lock();
        assertThat(lock.getHoldCount()).isEqualTo(2);
        lock.unlock();
        assertThat(lock.isHeldByCurrentThread()).isTrue();
        lock.unlock();
        assertThat(lock.isLocked()).isFalse();
        assertThat(lock.toString()).endsWith("[Unlocked]");
    }

    @Test
    void holderOfAFairLockMayLockAgainPastThoseWhoWait() throws InterruptedException {
        ReentrantLock fair = new ReentrantLock(true);
        fair.lock();
        Waiting other = Waiting.in(fair::lock);
        fair.lock();
        fair.lockInterruptibly();
        assertThat(fair.getHoldCount()).isEqualTo(3);
        fair.unlock();
        fair.unlock();
        fair.unlock();
        other.ends();
    }

    @Test
    void onlyTheHolderMayUnlock() throws InterruptedException {
        assertThatThrownBy(lock::unlock).isInstanceOf(IllegalMonitorStateException.class);
        lock.lock();
        assertThat(Waiting.started(lock::unlock).outcome()).isInstanceOf(IllegalMonitorStateException.class);
        assertThat(lock.toString()).endsWith("[Locked by thread " + Thread.currentThread().getName() + "]");
    }

    @Test
    void tryLockFailsWhileAnotherThreadHoldsTheLock() throws InterruptedException {
        lock.lock();
        boolean[] taken = {true, true};
        Waiting.started(() -> {
            taken[0] = lock.tryLock();
            taken[1] = lock.tryLock(1, TimeUnit.MILLISECONDS);
        }).ends();
        assertThat(taken).containsExactly(false, false);
        assertThat(lock.getQueueLength()).isZero();
    }

    @Test
    void interruptEndsWaitingOnlyWhereTheMethodSaysSo() throws InterruptedException {
        lock.lock();
        Waiting interruptible = Waiting.in(lock::lockInterruptibly);
        assertThat(interruptible.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        boolean[] flag = new boolean[1];
        Waiting patient = Waiting.in(() -> {
            lock.lock();
            flag[0] = Thread.currentThread().isInterrupted();
            lock.unlock();
        });
        patient.interrupted();
        lock.unlock();
        patient.ends();
        assertThat(flag[0]).isTrue();
    }

    @Test
    void anInterruptThatIsPendingComesBeforeTheLock() {
        Thread.currentThread().interrupt();
        assertThatThrownBy(lock::lockInterruptibly).isInstanceOf(InterruptedException.class);
        Thread.currentThread().interrupt();
        assertThatThrownBy(() -> lock.tryLock(1, TimeUnit.SECONDS)).isInstanceOf(InterruptedException.class);
        assertThat(lock.isLocked()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void waitingThreadsGetTheLockInOrderOfArrival(boolean fair) throws InterruptedException {
        ReentrantLock ordered = new ReentrantLock(fair);
        List<Integer> order = Collections.synchronizedList(new ArrayList<>());
        List<Waiting> threads = new ArrayList<>();
        ordered.lock();
        for (int i = 0; i < 4; i++) {
            int number = i;
            threads.add(Waiting.in(() -> {
                ordered.lock();
                order.add(number);
                ordered.unlock();
            }));
            assertThat(ordered.getQueueLength()).isEqualTo(i + 1);
            assertThat(ordered.hasQueuedThread(threads.get(i).thread())).isTrue();
        }
        ordered.unlock();
        for (Waiting thread : threads) {
            thread.ends();
        }
        assertThat(order).containsExactly(0, 1, 2, 3);
        assertThat(ordered.hasQueuedThreads()).isFalse();
    }

    @Test
    void conditionsNeedTheLock() {
        assertThatThrownBy(condition::signal).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(condition::signalAll).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(condition::await).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(condition::awaitUninterruptibly).isInstanceOf(IllegalMonitorStateException.class);
        assertThatThrownBy(() -> lock.hasWaiters(condition)).isInstanceOf(IllegalMonitorStateException.class);
        lock.lock();
        Condition foreign = new ReentrantLock().newCondition();
        assertThatThrownBy(() -> lock.hasWaiters(foreign)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void awaitReleasesAllHoldsAndTakesThemBack() throws InterruptedException {
        int[] holds = new int[1];
        Waiting waiter = Waiting.in(() -> {
            lock.lock();
            lock.lock();
            condition.await();
            holds[0] = lock.getHoldCount();
            lock.unlock();
            lock.unlock();
        });
        lock.lock();
        assertThat(lock.getWaitQueueLength(condition)).isEqualTo(1);
        assertThat(lock.getWaitingThreads(condition)).containsExactly(waiter.thread());
        condition.signal();
        lock.unlock();
        waiter.ends();
        assertThat(holds[0]).isEqualTo(2);
    }

    @Test
    void signalWakesTheLongestWaitingThreadAndSignalAllTheRest() throws InterruptedException {
        List<Integer> order = Collections.synchronizedList(new ArrayList<>());
        List<Waiting> threads = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            int number = i;
            threads.add(Waiting.in(() -> {
                lock.lock();
                condition.await();
                order.add(number);
                lock.unlock();
            }));
        }
        lock.lock();
        condition.signal();
        lock.unlock();
        threads.get(0).ends();
        assertThat(order).containsExactly(0);
        lock.lock();
        assertThat(lock.getWaitQueueLength(condition)).isEqualTo(2);
        condition.signalAll();
        assertThat(lock.hasWaiters(condition)).isFalse();
        lock.unlock();
        threads.get(1).ends();
        threads.get(2).ends();
        assertThat(order).contains(0, 1, 2);
    }

    @Test
    void awaitGivesUpWhenTimeHasPassed() throws InterruptedException {
        lock.lock();
        assertThat(condition.await(1, TimeUnit.MILLISECONDS)).isFalse();
        assertThat(condition.awaitNanos(1)).isNotPositive();
        assertThat(condition.awaitNanos(-5)).isNotPositive();
        assertThat(condition.awaitUntil(new Date(0))).isFalse();
        assertThat(lock.getHoldCount()).isEqualTo(1);
        assertThat(lock.hasWaiters(condition)).isFalse();
    }

    @Test
    void interruptedAwaitHoldsTheLockAgainAndIsNoLongerSignalled() throws InterruptedException {
        boolean[] held = new boolean[1];
        Waiting first = Waiting.in(() -> {
            lock.lock();
            try {
                condition.await();
            } finally {
                held[0] = lock.isHeldByCurrentThread();
                lock.unlock();
            }
        });
        Waiting second = Waiting.in(() -> {
            lock.lock();
            condition.await();
            lock.unlock();
        });
        assertThat(first.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        assertThat(held[0]).isTrue();
        lock.lock();
        condition.signal();
        lock.unlock();
        second.ends();
    }

    @Test
    void aSignalBeforeTheInterruptIsNotLost() throws InterruptedException {
        boolean[] flag = new boolean[1];
        Waiting waiter = Waiting.in(() -> {
            lock.lock();
            condition.await();
            flag[0] = Thread.currentThread().isInterrupted();
            lock.unlock();
        });
        lock.lock();
        condition.signal();
        waiter.interrupted();
        lock.unlock();
        waiter.ends();
        assertThat(flag[0]).isTrue();
    }

    @Test
    void awaitUninterruptiblyKeepsTheInterruptForLater() throws InterruptedException {
        boolean[] flag = new boolean[1];
        Waiting waiter = Waiting.in(() -> {
            lock.lock();
            condition.awaitUninterruptibly();
            flag[0] = Thread.currentThread().isInterrupted();
            lock.unlock();
        });
        waiter.interrupted();
        lock.lock();
        condition.signalAll();
        lock.unlock();
        waiter.ends();
        assertThat(flag[0]).isTrue();
    }
}
