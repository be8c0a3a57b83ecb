package programs.passing.interrupts;

/**
 * Interrupting a thread in wait throws InterruptedException there and clears the flag.
 *
 * @expected exited 0
 * @prints interrupted after 100 ms, flag false
 */
public class InterruptWait {
    private static final Object LOCK = new Object();

    public static void main(String[] args) throws InterruptedException {
        Thread sleeper = new Thread(() -> {
            long start = System.nanoTime();
            try {
                synchronized (LOCK) {
                    LOCK.wait();
                }
            } catch (InterruptedException e) {
                long millis = (System.nanoTime() - start) / 1_000_000;
                System.out.println("interrupted after " + (millis + 5) / 10 * 10 + " ms, flag " + Thread.currentThread()
                        .isInterrupted());
            }
        });
        sleeper.start();
        Thread.sleep(100);
        sleeper.interrupt();
        sleeper.join();
    }
}
