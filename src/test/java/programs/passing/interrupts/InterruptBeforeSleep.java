package programs.passing.interrupts;

/**
 * A thread that is interrupted before it sleeps does not sleep at all.
 *
 * @expected exited 0
 * @prints no sleep: true
 */
public class InterruptBeforeSleep {
    public static void main(String[] args) {
        Thread.currentThread().interrupt();
        long start = System.currentTimeMillis();
        try {
            Thread.sleep(1_000);
        } catch (InterruptedException e) {
            System.out.println("no sleep: " + (System.currentTimeMillis() - start < 10));
        }
    }
}
