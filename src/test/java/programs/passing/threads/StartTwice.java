package programs.passing.threads;

/**
 * A thread cannot be started twice, nor become a daemon once it runs.
 *
 * @expected exited 0
 * @prints not twice
 * @prints not now
 */
public class StartTwice {
    public static void main(String[] args) throws InterruptedException {
        Thread thread = new Thread(Thread::yield);
        thread.start();
        try {
            thread.start();
        } catch (IllegalThreadStateException e) {
            System.out.println("not twice");
        }
        try {
            thread.setDaemon(true);
        } catch (IllegalThreadStateException e) {
            System.out.println("not now");
        }
        thread.join();
    }
}
