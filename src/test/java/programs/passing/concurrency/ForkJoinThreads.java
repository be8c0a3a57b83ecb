package programs.passing.concurrency;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;

/**
 * A pool with worker threads of the program's own class, which sleep, are named and are interrupted like any thread.
 *
 * @expected exited 0
 * @prints worker begins
 * @prints worker sees itself true, alive true, daemon true
 * @prints interrupted in its sleep
 */
public class ForkJoinThreads {
    static final class Worker extends ForkJoinWorkerThread {
        Worker(ForkJoinPool pool) {
            super(pool);
        }

        @Override
        protected void onStart() {
            System.out.println("worker begins");
        }
    }

    private static volatile Thread worker;

    /** The program. */
    public static void main(String[] args) throws Exception {
        ForkJoinPool pool = new ForkJoinPool(1, Worker::new, null, false);
        pool.execute(() -> {
            worker = Thread.currentThread();
            System.out.println("worker sees itself " + (worker instanceof Worker) + ", alive " + worker.isAlive()
                    + ", daemon " + worker.isDaemon());
            try {
                Thread.sleep(10000);
            } catch (InterruptedException e) {
                System.out.println("interrupted in its sleep");
            }
        });
        Thread.sleep(500);
        worker.interrupt();
        Thread.sleep(500);
    }
}
