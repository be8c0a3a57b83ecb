package programs.passing.threads;

/**
 * Threads run when started and join waits for their end.
 *
 * @expected exited 0
 * @prints before
 * @prints in Thread-0
 * @prints in worker
 * @prints after
 */
public class StartAndJoin {
    public static void main(String[] args) throws InterruptedException {
        Runnable task = () -> System.out.println("in " + Thread.currentThread().getName());
        Thread first = new Thread(task);
        Thread second = new Thread(task, "worker");
        System.out.println("before");
        first.start();
        second.start();
        first.join();
        second.join();
        System.out.println("after");
    }
}
