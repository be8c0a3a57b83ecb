package brickless.bench;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;

/** Keeps all processors of this machine busy until it is closed. */
public final class BusyHost implements AutoCloseable {
    private final AtomicBoolean done = new AtomicBoolean();
    private final List<Thread> load = Stream.generate(this::thread)
            .limit(Runtime.getRuntime().availableProcessors()).toList();

    /** Begins. */
    public BusyHost() {
        load.forEach(Thread::start);
    }

    private Thread thread() {
        Thread thread = new Thread(() -> {
            while (!done.get()) {
                Thread.onSpinWait();
            }
        }, "other work");
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public void close() {
        done.set(true);
    }
}
