package programs.passing.threads;

import java.util.concurrent.locks.LockSupport;

/**
 * An unpark before a park is kept, one after it wakes the thread, and a park has its time limit.
 *
 * @expected exited 0
 * @prints permit kept
 * @prints woken at 100 ms
 * @prints gave up at 150 ms
 */
public class ParkAndUnpark {
    public static void main(String[] args) throws InterruptedException {
        long start = System.currentTimeMillis();
        LockSupport.unpark(Thread.currentThread());
        LockSupport.park();
        System.out.println("permit kept");
        Thread sleeper = new Thread(() -> {
            LockSupport.park(ParkAndUnpark.class);
            System.out.println("woken at " + (System.currentTimeMillis() - start) / 10 * 10 + " ms");
            LockSupport.parkNanos(50_000_000);
            System.out.println("gave up at " + (System.currentTimeMillis() - start) / 10 * 10 + " ms");
        });
        sleeper.start();
        Thread.sleep(100);
        LockSupport.unpark(sleeper);
        sleeper.join();
    }
}
