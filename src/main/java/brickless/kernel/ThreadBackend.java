package brickless.kernel;

import brickless.kernel.hooks.ProgramKilled;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;

/**
 * One platform thread for each fibre; exactly one has the turn, all others are parked.
 *
 * <p>The carrier that gave the turn away last may spin for a moment before it parks, because two threads often take
 * turns; see {@link SpinBackOff}. If it is not one of two, the next one to give the turn away puts an end to that, and
 * the spinning was in vain.
 */
final class ThreadBackend implements Backend {
    private final long stackBytes;
    private final CountDownLatch over = new CountDownLatch(1);
    private final Set<Carrier> carriers = ConcurrentHashMap.newKeySet();
    private Consumer<Throwable> onFailure;
    /** The carrier that may spin for its turn; one at a time, so that the others find a processor. */
    private volatile Carrier spinner;
    private volatile boolean abandoned;

    ThreadBackend(long stackBytes) {
        this.stackBytes = stackBytes;
    }

    @Override
    public String name() {
        return "threads";
    }

    @Override
    public void create(Fibre fibre) {
        fibre.stack = new Carrier(fibre, Thread.currentThread() instanceof Carrier);
    }

    @Override
    public void start(Fibre first, Consumer<Throwable> failureListener) {
        onFailure = failureListener;
        SpinBackOff.runBegins();
        give(first);
    }

    @Override
    public void awaitEnd() throws InterruptedException {
        over.await();
        if (!abandoned) {
            for (Carrier carrier : carriers) {
                carrier.join();
            }
        }
        SpinBackOff.runEnds();
    }

    @Override
    public void switchTo(Fibre from, Fibre to) {
        Carrier me = carrierOf(from);
        give(to);
        me.spin();
        me.turn.await();
        if (abandoned) {
            throw new ProgramKilled();
        }
    }

    @Override
    public void finish(Fibre from, Fibre to) {
        if (to == null) {
            over.countDown();
        } else {
            give(to);
        }
    }

    @Override
    public StackTraceElement[] stackOf(Fibre fibre) {
        return carrierOf(fibre).getStackTrace();
    }

    @Override
    public Thread hostThreadOf(Fibre fibre) {
        return carrierOf(fibre);
    }

    @Override
    public void abandon() {
        abandoned = true;
        carriers.forEach(carrier -> carrier.turn.release());
        over.countDown();
    }

    private void give(Fibre fibre) {
        try {
            carrierOf(fibre).turn.give();
        } catch (OutOfMemoryError e) {
            // The host has no thread left; the program must not take this for its own memory.
            onFailure.accept(e);
        }
    }

    private static Carrier carrierOf(Fibre fibre) {
        return (Carrier) fibre.stack;
    }

    /** The host thread of one fibre; started when the fibre first gets the turn. */
    private final class Carrier extends Thread {
        private final Fibre fibre;
        private final Turn turn = new Turn(this);
        private final SpinBackOff backOff = new SpinBackOff();

        Carrier(Fibre fibre, boolean inheritThreadLocals) {
            super(null, null, "brickless " + fibre.thread.getName(), stackBytes, inheritThreadLocals);
            this.fibre = fibre;
            setDaemon(true);
            setContextClassLoader(fibre.contextLoader);
        }

        /** Waits actively for the turn, as long as that may pay and no other carrier wants to. */
        void spin() {
            int spins = backOff.spins();
            if (spins == 0) {
                return;
            }
            spinner = this;
            for (int i = 0; i < spins && spinner == this && !turn.given(); i++) {
                Thread.onSpinWait();
            }
            if (turn.given()) {
                backOff.succeeded();
            } else {
                backOff.failed();
            }
        }

        @Override
        public void run() {
            carriers.add(this);
            try {
                turn.await();
                if (!abandoned) {
                    fibre.run();
                }
            } catch (Throwable e) {
                onFailure.accept(e);
            } finally {
                carriers.remove(this);
            }
        }
    }
}
