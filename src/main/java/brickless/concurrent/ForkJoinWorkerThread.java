package brickless.concurrent;

import java.util.Objects;

/** {@code java.util.concurrent.ForkJoinWorkerThread}: a daemon thread of a {@link ForkJoinPool}. */
public class ForkJoinWorkerThread extends Thread {
    private final ForkJoinPool pool;
    private int index;
    private Runnable work;

    /** Creates a thread of that pool. */
    protected ForkJoinWorkerThread(ForkJoinPool pool) {
        this.pool = Objects.requireNonNull(pool);
        setDaemon(true);
    }

    /** Called by the pool before the thread starts. */
    final void assign(int number, Runnable tasks) {
        index = number - 1;
        work = tasks;
        setName(pool.namePrefix() + number);
    }

    /** The pool. */
    public ForkJoinPool getPool() {
        return pool;
    }

    /** Number of the thread in the pool, from 0. */
    public int getPoolIndex() {
        return index;
    }

    /** Called in the thread before its first task; does nothing. */
    protected void onStart() {
    }

    /** Called in the thread when it ends, with what ended it or null; does nothing. */
    protected void onTermination(Throwable exception) {
    }

    @Override
    public void run() {
        try {
            onStart();
            work.run();
        } catch (Throwable t) {
            onTermination(t);
            throw t;
        }
        onTermination(null);
    }
}
