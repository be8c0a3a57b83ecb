package programs.failing.runaways;

/**
 * Two threads that keep interrupting each other and go on all the same end at the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class IgnoresInterrupts {
    public static void main(String[] args) {
        Thread main = Thread.currentThread();
        Thread other = new Thread(() -> poke(main));
        other.start();
        poke(other);
    }

    private static void poke(Thread victim) {
        while (true) {
            try {
                Thread.sleep(10);
            } catch (InterruptedException e) {
                victim.interrupt();
            }
            victim.interrupt();
        }
    }
}
