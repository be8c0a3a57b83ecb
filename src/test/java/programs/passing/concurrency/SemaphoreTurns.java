package programs.passing.concurrency;

import java.util.concurrent.Semaphore;

/**
 * Two semaphores make two threads alternate.
 *
 * @expected exited 0
 * @prints left
 * @prints right
 * @prints left
 * @prints right
 * @prints permits 1
 */
public class SemaphoreTurns {
    private static void turn(String name, Semaphore mine, Semaphore others) {
        for (int i = 0; i < 2; i++) {
            mine.acquireUninterruptibly();
            System.out.println(name);
            others.release();
        }
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        Semaphore left = new Semaphore(1);
        Semaphore right = new Semaphore(0);
        Thread a = new Thread(() -> turn("left", left, right));
        Thread b = new Thread(() -> turn("right", right, left));
        b.start();
        a.start();
        a.join();
        b.join();
        System.out.println("permits " + left.availablePermits());
    }
}
