package programs.passing.monitors;

/**
 * A wait with a time limit gives up after it, and holds the monitor again.
 *
 * @expected exited 0
 * @prints 250 ms, holding true
 * @prints 1 ms, holding true
 */
public class WaitWithTimeout {
    public static void main(String[] args) throws InterruptedException {
        Object lock = new Object();
        synchronized (lock) {
            long start = System.currentTimeMillis();
            lock.wait(250);
            System.out.println(System.currentTimeMillis() - start + " ms, holding " + Thread.holdsLock(lock));
            start = System.currentTimeMillis();
            lock.wait(0, 999_999);
            System.out.println(System.currentTimeMillis() - start + " ms, holding " + Thread.holdsLock(lock));
        }
    }
}
