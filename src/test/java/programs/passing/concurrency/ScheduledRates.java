package programs.passing.concurrency;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;

/**
 * Fixed rate keeps the beat although the task takes time; fixed delay does not. Times are rounded to 10 ms.
 *
 * @expected exited 0
 * @prints rate at 50
 * @prints rate at 150
 * @prints rate at 250
 * @prints delay at 50
 * @prints delay at 180
 * @prints delay at 310
 * @prints cancelled true
 */
public class ScheduledRates {
    private static Runnable task(String name, CountDownLatch left) {
        long start = System.nanoTime();
        return () -> {
            if (left.getCount() == 0) {
                return;
            }
            long millis = (System.nanoTime() - start) / 1000000;
            System.out.println(name + " at " + (millis + 5) / 10 * 10);
            try {
                Thread.sleep(30);
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
            left.countDown();
        };
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        ScheduledExecutorService scheduler = Executors.newScheduledThreadPool(1);
        CountDownLatch rated = new CountDownLatch(3);
        Runnable rate = task("rate", rated);
        ScheduledFuture<?> atRate = scheduler.scheduleAtFixedRate(rate, 50, 100, TimeUnit.MILLISECONDS);
        rated.await();
        atRate.cancel(false);
        CountDownLatch delayed = new CountDownLatch(3);
        Runnable delay = task("delay", delayed);
        ScheduledFuture<?> withDelay = scheduler.scheduleWithFixedDelay(delay, 50, 100, TimeUnit.MILLISECONDS);
        delayed.await();
        withDelay.cancel(false);
        System.out.println("cancelled " + withDelay.isCancelled());
        scheduler.shutdown();
    }
}
