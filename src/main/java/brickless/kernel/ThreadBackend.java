package brickless.kernel;

import brickless.kernel.hooks.ProgramKilled;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * One platform thread for each fibre; exactly one has the turn, all others are parked.
 *
 * <p>The carrier that gave the turn away last spins for a moment before it parks, because threads often come back at once (waking a
 * parked thread costs some 20 µs, a spinning one less than 1 µs).
 */
final class ThreadBackend implements Backend {
    private static final int SPINS = Runtime.getRuntime().availableProcessors() > 1 ? 2_000 : 0;

    private final long stackBytes;
    private final CountDownLatch over = new CountDownLatch(1);
    private final Set<Carrier> carriers = ConcurrentHashMap.newKeySet();
    private Consumer<Throwable> onFailure;
    private volatile Carrier lastLeft;
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
        boolean inherit = Thread.currentThread() instanceof Carrier;
        fibre.stack = new Carrier(fibre, inherit);
    }

    @Override
    public void start(Fibre first, Consumer<Throwable> failureListener) {
        onFailure = failureListener;
        carrierOf(first).giveTurn();
    }

    @Override
    public void awaitEnd() throws InterruptedException {
        over.await();
        if (!abandoned) {
            for (Carrier carrier : carriers) {
                carrier.join();
            }
        }
    }

    @Override
    public void switchTo(Fibre from, Fibre to) {
        Carrier me = carrierOf(from);
        lastLeft = me;
        carrierOf(to).giveTurn();
        me.awaitTurn();
    }

    @Override
    public void finish(Fibre from, Fibre to) {
        lastLeft = null;
        if (to == null) {
            over.countDown();
        } else {
            carrierOf(to).giveTurn();
        }
    }

    @Override
    public StackTraceElement[] stackOf(Fibre fibre) {
        return carrierOf(fibre).getStackTrace();
    }

    @Override
    public void abandon() {
        abandoned = true;
        for (Carrier carrier : carriers) {
            LockSupport.unpark(carrier);
        }
        over.countDown();
    }

    private static Carrier carrierOf(Fibre fibre) {
        return (Carrier) fibre.stack;
    }

    /** The host thread of one fibre; started when the fibre first gets the turn. */
    private final class Carrier extends Thread {
        private final Fibre fibre;
        /** Guarded by the turn of the giver. */
        private boolean begun;
        private volatile boolean turn;
        private volatile boolean parked;

        Carrier(Fibre fibre, boolean inheritThreadLocals) {
            super(null, null, "brickless " + fibre.thread.getName(), stackBytes, inheritThreadLocals);
            this.fibre = fibre;
            setDaemon(true);
            setContextClassLoader(fibre.contextLoader);
        }

        @Override
        public void run() {
            try {
                fibre.run();
            } catch (Throwable e) {
                onFailure.accept(e);
            } finally {
                carriers.remove(this);
            }
        }

        void giveTurn() {
            if (begun) {
                turn = true;
                if (parked) {
                    LockSupport.unpark(this);
                }
            } else {
                begun = true;
                begin();
            }
        }

        void awaitTurn() {
            for (int i = 0; i < SPINS && !turn && lastLeft == this; i++) {
                Thread.onSpinWait();
            }
            parked = true;
            while (!turn && !abandoned) {
                LockSupport.park(this);
                Thread.interrupted();
            }
            parked = false;
            turn = false;
            if (abandoned) {
                throw new ProgramKilled();
            }
        }

        private void begin() {
            carriers.add(this);
            try {
                start();
            } catch (Throwable e) {
                carriers.remove(this);
                onFailure.accept(e);
            }
        }
    }
}
