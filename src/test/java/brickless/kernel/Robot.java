package brickless.kernel;

import java.util.ArrayList;
import java.util.List;

/**
 * A kernel with a program written against it by hand, as rewriting would have produced it, and a log with virtual
 * times.
 */
final class Robot {
    static final long MILLI = 1_000_000L;

    final CountingBudget budget = new CountingBudget();
    final List<String> log = new ArrayList<>();
    final Kernel kernel;

    /** A program's code. */
    interface Body {
        void run() throws Exception;
    }

    Robot(KernelSettings settings, StepHandler stepHandler) {
        kernel = new Kernel(settings, stepHandler);
        kernel.bind(budget);
    }

    Robot(KernelSettings settings) {
        this(settings, null);
    }

    static KernelSettings settings(BackendChoice backend) {
        return KernelSettings.defaults().withBackend(backend);
    }

    ProgramEnd run(Body main) {
        return kernel.run(thread("main", main), runnable(main));
    }

    /** Starts a program thread. */
    Thread start(String name, Body body) {
        Thread thread = thread(name, body);
        kernel.start(thread);
        return thread;
    }

    Thread startDaemon(String name, Body body) {
        Thread thread = thread(name, body);
        thread.setDaemon(true);
        kernel.start(thread);
        return thread;
    }

    /** A program thread that is not started. */
    static Thread thread(String name, Body body) {
        Thread thread = new Thread(runnable(body), name);
        thread.setDaemon(false);
        return thread;
    }

    static Runnable runnable(Body body) {
        return () -> {
            try {
                body.run();
            } catch (Exception e) {
                throw Robot.<RuntimeException>unchecked(e);
            }
        };
    }

    /** A busy loop of some virtual duration. */
    void work(long nanos) {
        for (long done = 0; done < nanos; done += Costs.BACK_EDGE_NANOS) {
            budget.tick(kernel);
        }
    }

    /** {@code while (true) { }}. */
    void spin() {
        while (true) {
            budget.tick(kernel);
        }
    }

    void sleepMillis(long millis) throws InterruptedException {
        kernel.sleep(millis * MILLI);
    }

    /** {@code synchronized (lock) { … }}. */
    void locked(Object lock, Body body) throws Exception {
        kernel.monitorEnter(lock);
        try {
            body.run();
        } finally {
            kernel.monitorExit(lock);
        }
    }

    /** Notes a word with the virtual time in whole milliseconds. */
    void note(String word) {
        log.add(kernel.nowNanos() / MILLI + " " + word);
    }

    @SuppressWarnings("unchecked")
    private static <E extends Exception> E unchecked(Exception e) throws E {
        throw (E) e;
    }
}
