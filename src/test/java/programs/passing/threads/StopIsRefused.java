package programs.passing.threads;

/**
 * Thread.stop was never safe and is gone from Java: refused, with a word about what to use instead.
 *
 * @expected exited 0
 * @prints Thread.stop, suspend and resume are not supported: use interrupt()
 * @prints interrupted
 */
public class StopIsRefused {
    @SuppressWarnings({"deprecation", "removal"})
    public static void main(String[] args) throws InterruptedException {
        Thread victim = new Thread(() -> {
            try {
                Thread.sleep(60_000);
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        victim.start();
        try {
            victim.stop();
        } catch (UnsupportedOperationException e) {
            System.out.println(e.getMessage());
        }
        victim.interrupt();
        victim.join();
    }
}
