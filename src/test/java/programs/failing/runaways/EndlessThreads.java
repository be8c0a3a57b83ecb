package programs.failing.runaways;

/**
 * A program that starts threads for ever gets an OutOfMemoryError.
 *
 * @expected failed java.lang.OutOfMemoryError
 */
public class EndlessThreads {
    public static void main(String[] args) {
        while (true) {
            Thread thread = new Thread(() -> {
                synchronized (EndlessThreads.class) {
                    try {
                        EndlessThreads.class.wait(2000);
                    } catch (InterruptedException e) {
                        return;
                    }
                }
            });
            thread.start();
        }
    }
}
