package programs.passing.concurrency;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * A latch starts three threads together, a barrier keeps them in step, another latch tells when all are done.
 *
 * @expected exited 0
 * @prints round 1
 * @prints round 2
 * @prints done, 0 missing
 * @prints all 6
 */
public class LatchesAndBarrier {
    /** The program. */
    public static void main(String[] args) throws Exception {
        CountDownLatch start = new CountDownLatch(1);
        CountDownLatch done = new CountDownLatch(3);
        AtomicInteger rounds = new AtomicInteger();
        AtomicInteger arrivals = new AtomicInteger();
        CyclicBarrier barrier = new CyclicBarrier(3, () -> System.out.println("round " + rounds.incrementAndGet()));
        for (int i = 0; i < 3; i++) {
            new Thread(() -> {
                try {
                    start.await();
                    for (int round = 0; round < 2; round++) {
                        arrivals.incrementAndGet();
                        barrier.await();
                    }
                } catch (Exception e) {
                    System.out.println(e);
                }
                done.countDown();
            }).start();
        }
        start.countDown();
        done.await();
        System.out.println("done, " + done.getCount() + " missing");
        System.out.println("all " + arrivals.get());
    }
}
