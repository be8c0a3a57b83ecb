package programs.passing.concurrency;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;

/**
 * A pool with worker threads of the program's own class, which sleep, are named and are interrupted like any thread.
 *
 * @expected exited 0
 * @prints worker begins
 * @prints worker sees itself true, alive true, daemon true
 * @prints interrupted after 50 ms
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
            long begin = System.currentTimeMillis();
            System.out.println("worker sees itself " + (worker instanceof Worker) + ", alive " + worker.isAlive()
                    + ", daemon " + worker.isDaemon());
            try {
                Thread.sleep(1000);
            } catch (InterruptedException e) {
                System.out.println("interrupted after " + (System.currentTimeMillis() - begin) / 10 * 10 + " ms");
            }
        });
        Thread.sleep(50);
        worker.interrupt();
        Thread.sleep(50);
    }
}
