package programs.passing.exit;

/**
 * System.exit works on any thread: here while the main thread waits for ever.
 *
 * @expected exited 4
 * @prints leaving
 */
public class ExitFromAnotherThread {
    public static void main(String[] args) throws InterruptedException {
        new Thread(() -> {
            System.out.println("leaving");
            Runtime.getRuntime().exit(4);
        }).start();
        synchronized (args) {
            args.wait();
        }
    }
}
