package programs.failing.uncaught;

/**
 * An exception in an uncaught exception handler is ignored; the program goes on and fails because of the first one.
 *
 * @expected exited 0
 * @prints handler of worker
 * @prints main ends
 */
public class HandlerThrows {
    public static void main(String[] args) throws InterruptedException {
        Thread worker = new Thread(() -> {
            throw new IllegalStateException("broken");
        }, "worker");
        worker.setUncaughtExceptionHandler((thread, failure) -> {
            System.out.println("handler of " + thread.getName());
            throw new IllegalArgumentException("broken as well");
        });
        worker.start();
        worker.join();
        System.out.println("main ends");
    }
}
