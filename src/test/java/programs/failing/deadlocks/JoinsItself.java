package programs.failing.deadlocks;

/**
 * A thread that waits for its own end waits for ever.
 *
 * @expected deadlock
 */
public class JoinsItself {
    public static void main(String[] args) throws InterruptedException {
        Thread.currentThread().join();
    }
}
