package programs.passing.threads;

/**
 * Thread states follow a thread's life.
 *
 * @expected exited 0
 * @prints NEW
 * @prints WAITING
 * @prints BLOCKED
 * @prints RUNNABLE
 * @prints TERMINATED
 */
public class ThreadStates {
    private static boolean go;

    public static void main(String[] args) throws InterruptedException {
        Object lock = new Object();
        Thread thread = new Thread(() -> {
            synchronized (lock) {
                try {
                    while (!go) {
                        lock.wait();
                    }
                } catch (InterruptedException e) {
                    System.out.println("unexpected");
                }
            }
            for (int i = 0; i < 1_000_000; i++) {
                Math.sqrt(i);
            }
        });
        System.out.println(thread.getState());
        thread.start();
        Thread.sleep(10);
        System.out.println(thread.getState());
        synchronized (lock) {
            go = true;
            lock.notifyAll();
            System.out.println(thread.getState());
        }
        Thread.sleep(10);
        System.out.println(thread.getState());
        thread.join();
        System.out.println(thread.getState());
    }
}
