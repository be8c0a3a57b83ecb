package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class SynchronizersTest {
    @Test
    void latchOpensAtZeroAndStaysOpen() throws InterruptedException {
        CountDownLatch latch = new CountDownLatch(2);
        Waiting waiter = Waiting.in(latch::await);
        latch.countDown();
        assertThat(latch.await(1, TimeUnit.MILLISECONDS)).isFalse();
        latch.countDown();
        waiter.ends();
        latch.countDown();
        assertThat(latch.getCount()).isZero();
        assertThat(latch.await(0, TimeUnit.SECONDS)).isTrue();
        assertThat(latch.toString()).endsWith("[Count = 0]");
    }

    @Test
    void interruptedThreadCannotPassEvenAnOpenLatch() {
        Thread.currentThread().interrupt();
        assertThatThrownBy(new CountDownLatch(0)::await).isInstanceOf(InterruptedException.class);
        assertThatThrownBy(() -> new CountDownLatch(-1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void semaphoreCountsPermits() throws InterruptedException {
        Semaphore semaphore = new Semaphore(3);
        semaphore.acquire(2);
        assertThat(semaphore.tryAcquire(2)).isFalse();
        assertThat(semaphore.tryAcquire(2, 1, TimeUnit.MILLISECONDS)).isFalse();
        semaphore.release(4);
        assertThat(semaphore.drainPermits()).isEqualTo(5);
        semaphore.reducePermits(2);
        assertThat(semaphore.availablePermits()).isEqualTo(-2);
        assertThatThrownBy(() -> semaphore.release(-1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Semaphore(Integer.MAX_VALUE).release()).isInstanceOf(Error.class);
    }

    @Test
    void fairSemaphoreServesTheFirstInLineFirst() throws InterruptedException {
        Semaphore semaphore = new Semaphore(0, true);
        Waiting large = Waiting.in(() -> semaphore.acquire(2));
        Waiting small = Waiting.in(semaphore::acquire);
        semaphore.release();
        assertThat(semaphore.getQueueLength()).isEqualTo(2);
        assertThat(semaphore.tryAcquire()).as("barges").isTrue();
        semaphore.release(2);
        large.ends();
        assertThat(semaphore.getQueuedThreads()).containsExactly(small.thread());
        semaphore.release();
        small.ends();
    }

    @Test
    void barrierTellsHowManyWereMissing() throws Exception {
        List<String> trips = new ArrayList<>();
        CyclicBarrier barrier = new CyclicBarrier(3, () -> trips.add("trip"));
        for (int round = 1; round <= 2; round++) {
            int[] missing = new int[2];
            Waiting first = Waiting.in(() -> missing[0] = barrier.await());
            Waiting second = Waiting.in(() -> missing[1] = barrier.await());
            assertThat(barrier.getNumberWaiting()).isEqualTo(2);
            assertThat(barrier.await()).isZero();
            first.ends();
            second.ends();
            assertThat(missing).containsExactly(2, 1);
            assertThat(trips).hasSize(round);
        }
    }

    @Test
    void interruptBreaksTheBarrierForAll() throws InterruptedException {
        CyclicBarrier barrier = new CyclicBarrier(3);
        Waiting first = Waiting.in(barrier::await);
        Waiting second = Waiting.in(barrier::await);
        assertThat(first.interrupted().outcome()).isInstanceOf(InterruptedException.class);
        assertThat(second.outcome()).isInstanceOf(BrokenBarrierException.class);
        assertThat(barrier.isBroken()).isTrue();
        assertThatThrownBy(barrier::await).isInstanceOf(BrokenBarrierException.class);
        barrier.reset();
        assertThat(barrier.isBroken()).isFalse();
    }

    @Test
    void timeOutFailedActionAndResetBreakTheBarrier() throws InterruptedException {
        CyclicBarrier timed = new CyclicBarrier(2);
        assertThatThrownBy(() -> timed.await(1, TimeUnit.MILLISECONDS)).isInstanceOf(TimeoutException.class);
        assertThat(timed.isBroken()).isTrue();
        CyclicBarrier failing = new CyclicBarrier(2, () -> {
            throw new IllegalStateException("action");
        });
        Waiting other = Waiting.in(failing::await);
        assertThatThrownBy(failing::await).hasMessage("action");
        assertThat(other.outcome()).isInstanceOf(BrokenBarrierException.class);
        CyclicBarrier reset = new CyclicBarrier(2);
        Waiting waiter = Waiting.in(reset::await);
        reset.reset();
        assertThat(waiter.outcome()).isInstanceOf(BrokenBarrierException.class);
    }

    @Test
    void exchangerSwapsNullsTooAndForgetsThoseWhoGaveUp() throws Exception {
        Exchanger<String> exchanger = new Exchanger<>();
        assertThatThrownBy(() -> exchanger.exchange("late", 1, TimeUnit.MILLISECONDS))
                .isInstanceOf(TimeoutException.class);
        String[] received = {"nothing"};
        Waiting partner = Waiting.in(() -> received[0] = exchanger.exchange("given"));
        assertThat(exchanger.exchange(null)).isEqualTo("given");
        partner.ends();
        assertThat(received[0]).isNull();
    }

    @Test
    void phaserAdvancesWhenAllHaveArrived() throws Exception {
        Phaser phaser = new Phaser(2);
        assertThat(phaser.register()).isZero();
        assertThat(phaser.arrive()).isZero();
        assertThat(phaser.arriveAndDeregister()).isZero();
        assertThat(phaser.getUnarrivedParties()).isEqualTo(1);
        assertThatThrownBy(() -> phaser.awaitAdvanceInterruptibly(0, 1, TimeUnit.MILLISECONDS))
                .isInstanceOf(TimeoutException.class);
        Waiting waiter = Waiting.in(() -> phaser.awaitAdvance(0));
        assertThat(phaser.arriveAndAwaitAdvance()).isEqualTo(1);
        waiter.ends();
        assertThat(phaser.getRegisteredParties()).isEqualTo(2);
        assertThat(phaser.awaitAdvance(0)).isEqualTo(1);
        assertThat(phaser.toString()).endsWith("[phase = 1 parties = 2 arrived = 0]");
    }

    @Test
    void phaserWithoutPartiesTerminates() {
        Phaser phaser = new Phaser(1);
        assertThat(phaser.arriveAndDeregister()).isZero();
        assertThat(phaser.isTerminated()).isTrue();
        assertThat(phaser.getPhase()).isNegative();
        assertThat(phaser.arrive()).isNegative();
        assertThat(phaser.register()).isNegative();
    }

    @Test
    void unregisteredArrivalIsAnError() {
        assertThatThrownBy(new Phaser()::arrive).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void phasersOfATreeAdvanceTogether() {
        Phaser root = new Phaser();
        Phaser left = new Phaser(root, 2);
        Phaser right = new Phaser(root, 1);
        assertThat(root.getRegisteredParties()).isEqualTo(2);
        left.arrive();
        left.arrive();
        assertThat(root.getArrivedParties()).isEqualTo(1);
        right.arrive();
        assertThat(left.getPhase()).isEqualTo(1);
        assertThat(left.getArrivedParties()).isZero();
        right.arriveAndDeregister();
        assertThat(root.getRegisteredParties()).isEqualTo(1);
        assertThat(left.getRoot()).isSameAs(root);
    }

    @Test
    void phaserAgreesWithTheJdkAboutATreeStepByStep() {
        java.util.concurrent.Phaser jdkRoot = new java.util.concurrent.Phaser();
        java.util.concurrent.Phaser jdkLeaf = new java.util.concurrent.Phaser(jdkRoot, 1);
        Phaser root = new Phaser();
        Phaser leaf = new Phaser(root, 1);
        for (int step = 0; step < 40; step++) {
            switch (step * 7 % 5) {
                case 0:
                    assertThat(leaf.register()).as("step " + step).isEqualTo(jdkLeaf.register());
                    break;
                case 1:
                    boolean spare = jdkLeaf.getUnarrivedParties() > 0 && jdkLeaf.getRegisteredParties() > 1;
                    if (spare) {
                        assertThat(leaf.arriveAndDeregister()).as("step " + step)
                                .isEqualTo(jdkLeaf.arriveAndDeregister());
                    }
                    break;
                default:
                    assertThat(leaf.arrive()).as("step " + step).isEqualTo(jdkLeaf.arrive());
            }
            assertThat(root.getPhase()).as("step " + step).isEqualTo(jdkRoot.getPhase());
            assertThat(leaf.getUnarrivedParties()).as("step " + step).isEqualTo(jdkLeaf.getUnarrivedParties());
        }
    }
}
