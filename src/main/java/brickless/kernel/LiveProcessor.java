package brickless.kernel;

import java.util.Objects;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * The processor of live mode: program threads are real ones, time is the host's, and a pacer thread makes the physics
 * steps.
 *
 * <p>Devices are not thread-safe. Physics steps run under one lock; whoever wires the sockets wraps each socket call
 * in {@link #exclusively}, and waits for signals give the lock up. Charges add up for each thread and are slept off
 * in portions of a millisecond, so that polling loops poll about as often as on a brick and leave the host's
 * processor alone.
 */
public final class LiveProcessor implements Processor, AutoCloseable {
    private static final long SLEPT_OFF_NANOS = 1_000_000L;

    private final ReentrantLock lock = new ReentrantLock();
    /** Never signalled: waiting for it is sleeping without the lock. */
    private final Condition never = lock.newCondition();
    private final Condition closing = lock.newCondition();
    private final ThreadLocal<long[]> debtNanos = ThreadLocal.withInitial(() -> new long[1]);
    private final StepHandler stepHandler;
    private final Thread pacer;
    /** Guarded by the lock. */
    private final Pace pace;
    /** Guarded by the lock. */
    private boolean closed;

    /**
     * Creates a processor whose time is 0 now; {@link #start} makes the world move.
     *
     * @param stepNanos length of the physics step, positive
     */
    public LiveProcessor(long stepNanos, StepHandler stepHandler) {
        if (stepNanos <= 0) {
            throw new IllegalArgumentException("step must be positive: " + stepNanos + " ns");
        }
        this.stepHandler = Objects.requireNonNull(stepHandler, "stepHandler");
        pace = new Pace(stepNanos, System.nanoTime());
        pacer = new Thread(this::makeSteps, "brickless pacer");
        pacer.setDaemon(true);
    }

    /**
     * Starts the pacer, a daemon thread: it does not keep the JVM alive. What a step handler throws ends it like any
     * thread.
     */
    public void start() {
        pacer.start();
    }

    /** Stops the pacer after the step it is in; threads that wait for signals go on waiting. */
    @Override
    public void close() {
        exclusively(() -> {
            closed = true;
            closing.signalAll();
        });
    }

    /** Runs an action while no physics step runs and nobody else is inside; may be nested. */
    public void exclusively(Runnable action) {
        lock.lock();
        try {
            action.run();
        } finally {
            lock.unlock();
        }
    }

    /** Runs a computation while no physics step runs and nobody else is inside; may be nested. */
    public <T> T exclusively(Supplier<T> computation) {
        lock.lock();
        try {
            return computation.get();
        } finally {
            lock.unlock();
        }
    }

    @Override
    public long nowNanos() {
        lock.lock();
        try {
            return pace.now(System.nanoTime());
        } finally {
            lock.unlock();
        }
    }

    @Override
    public void charge(long nanos) {
        if (nanos < 0) {
            throw new IllegalArgumentException("negative charge: " + nanos + " ns");
        }
        long[] debt = debtNanos.get();
        debt[0] += nanos;
        if (debt[0] >= SLEPT_OFF_NANOS) {
            long before = System.nanoTime();
            awaitUninterruptibly(never, debt[0]);
            debt[0] -= System.nanoTime() - before;
        }
    }

    @Override
    public Signal newSignal() {
        return new LiveSignal();
    }

    private void makeSteps() {
        lock.lock();
        try {
            while (!closed) {
                for (int due = pace.due(System.nanoTime()); due > 0 && !closed; due--) {
                    stepHandler.step(pace.step());
                }
                closing.awaitNanos(Math.max(1, pace.untilNextStep(System.nanoTime())));
            }
        } catch (InterruptedException e) {
            // Only a host that shuts down interrupts this thread.
            Thread.currentThread().interrupt();
        } finally {
            lock.unlock();
        }
    }

    /** Waits for a condition for about some time; keeps an interrupt for later. */
    private void awaitUninterruptibly(Condition condition, long nanos) {
        boolean interrupted = false;
        lock.lock();
        try {
            long left = nanos;
            while (left > 0) {
                try {
                    left = condition.awaitNanos(left);
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } finally {
            lock.unlock();
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private final class LiveSignal implements Signal {
        private final Condition raised = lock.newCondition();
        /** Guarded by the lock. */
        private long raises;

        @Override
        public void raise() {
            exclusively(() -> {
                raises++;
                raised.signalAll();
            });
        }

        @Override
        public boolean await(long timeoutNanos) {
            boolean interrupted = Thread.interrupted();
            long deadline = System.nanoTime() + timeoutNanos;
            lock.lock();
            try {
                long before = raises;
                while (true) {
                    try {
                        return await(before, timeoutNanos == 0 ? 0 : Math.max(1, deadline - System.nanoTime()));
                    } catch (InterruptedException e) {
                        interrupted = true;
                    }
                }
            } finally {
                lock.unlock();
                if (interrupted) {
                    Thread.currentThread().interrupt();
                }
            }
        }

        /** The lock is held from the look to the wait, so no raise gets in between. */
        @Override
        public void awaitWhile(BooleanSupplier condition) {
            exclusively(() -> {
                while (condition.getAsBoolean()) {
                    raised.awaitUninterruptibly();
                }
            });
        }

        @Override
        public boolean awaitInterruptibly(long timeoutNanos) throws InterruptedException {
            lock.lockInterruptibly();
            try {
                return await(raises, timeoutNanos);
            } finally {
                lock.unlock();
            }
        }

        private boolean await(long before, long timeoutNanos) throws InterruptedException {
            if (timeoutNanos < 0) {
                throw new IllegalArgumentException("negative timeout: " + timeoutNanos + " ns");
            }
            long left = timeoutNanos == 0 ? Long.MAX_VALUE : timeoutNanos;
            while (raises == before && left > 0) {
                left = raised.awaitNanos(left);
            }
            return raises != before;
        }
    }
}
