package programs.failing.uncaught;

/**
 * An uncaught exception in another thread lets the rest of the program go on, which then ends as failed.
 *
 * @expected failed java.lang.IllegalStateException
 * @contains Exception in thread "worker" java.lang.IllegalStateException: broken
 * @contains main ends
 */
public class UncaughtInAThread {
    public static void main(String[] args) throws InterruptedException {
        Thread worker = new Thread(() -> {
            throw new IllegalStateException("broken");
        }, "worker");
        worker.start();
        worker.join();
        System.out.println("main ends");
    }
}
