package brickless.kernel;

import brickless.kernel.hooks.ProgramKilled;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;

/**
 * Each fibre is a continuation; one host thread, the carrier, runs them all.
 *
 * <p>A stack with a native frame on it (a static initialiser, reflection) or a JVM monitor held cannot be left. Such
 * a fibre keeps its carrier, which parks, and another carrier runs the others until its turn comes: for that time it
 * is what {@link ThreadBackend} makes of every fibre. Exactly one carrier has the turn; it owns all fields that are
 * not volatile.
 */
final class ContinuationBackend implements Backend {
    private final long stackBytes;
    private final CountDownLatch over = new CountDownLatch(1);
    private final Set<Carrier> carriers = ConcurrentHashMap.newKeySet();
    private final Deque<Carrier> idle = new ArrayDeque<>();
    private Consumer<Throwable> onFailure;
    /** Who runs next, null when the run is over. */
    private Fibre next;
    private volatile boolean ended;
    private volatile boolean abandoned;

    ContinuationBackend(long stackBytes) {
        this.stackBytes = stackBytes;
    }

    @Override
    public String name() {
        return "continuation";
    }

    @Override
    public void create(Fibre fibre) {
        fibre.stack = new Strand(fibre, Thread.currentThread() instanceof Carrier);
    }

    @Override
    public void start(Fibre first, Consumer<Throwable> failureListener) {
        onFailure = failureListener;
        next = first;
        give(new Carrier());
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
        next = to;
        if (!ContinuationAccess.yield()) {
            waitPinned(strandOf(from));
        }
    }

    @Override
    public void finish(Fibre from, Fibre to) {
        next = to;
    }

    @Override
    public StackTraceElement[] stackOf(Fibre fibre) {
        Thread carrier = hostThreadOf(fibre);
        return carrier != null ? carrier.getStackTrace() : ContinuationAccess.stackOf(strandOf(fibre).continuation);
    }

    @Override
    public Thread hostThreadOf(Fibre fibre) {
        for (Carrier carrier : carriers) {
            if (carrier.mounted == fibre.stack) {
                return carrier;
            }
        }
        return null;
    }

    @Override
    public void abandon() {
        abandoned = true;
        endRun();
    }

    private static Strand strandOf(Fibre fibre) {
        return (Strand) fibre.stack;
    }

    /** The calling fibre cannot leave its carrier: another one goes on with the others. */
    private void waitPinned(Strand strand) {
        Carrier carrier = (Carrier) Thread.currentThread();
        strand.pinnedTo = carrier;
        Carrier other = strandOf(next).pinnedTo;
        give(other != null ? other : spareCarrier());
        carrier.turn.await();
        strand.pinnedTo = null;
        if (ended) {
            throw new ProgramKilled();
        }
    }

    private Carrier spareCarrier() {
        return idle.isEmpty() ? new Carrier() : idle.pop();
    }

    private void give(Carrier carrier) {
        try {
            carrier.turn.give();
        } catch (OutOfMemoryError e) {
            // The host has no thread left; the program must not take this for its own memory.
            onFailure.accept(e);
        }
    }

    private void endRun() {
        ended = true;
        carriers.forEach(carrier -> carrier.turn.release());
        over.countDown();
    }

    /** A fibre's continuation with the thread locals it takes along. */
    private static final class Strand {
        private final Object continuation;
        private final ClassLoader contextLoader;
        private Object locals;
        private Object inheritableLocals;
        /** The carrier that waits until this fibre, which cannot leave it, has the turn; else null. */
        private Carrier pinnedTo;

        Strand(Fibre fibre, boolean inheritThreadLocals) {
            continuation = ContinuationAccess.create(fibre::run);
            contextLoader = fibre.contextLoader;
            // A thread that is never started, but whose constructor inherits like any other's.
            Thread heir = new Thread(null, null, "heir", 0, inheritThreadLocals);
            inheritableLocals = ContinuationAccess.inheritableLocals(heir);
        }

        /** Runs on a carrier until the fibre is switched away from or ends. */
        void mount(Carrier carrier) {
            carrier.receive(this);
            if (locals != null || inheritableLocals != null) {
                ContinuationAccess.setLocals(carrier, locals, inheritableLocals);
            }
            try {
                ContinuationAccess.run(continuation);
            } finally {
                locals = ContinuationAccess.locals(carrier);
                inheritableLocals = ContinuationAccess.inheritableLocals(carrier);
                if (locals != null || inheritableLocals != null) {
                    ContinuationAccess.setLocals(carrier, null, null);
                }
                carrier.mounted = null;
            }
        }
    }

    /** A host thread that runs continuations while it has the turn. */
    private final class Carrier extends Thread {
        private final Turn turn = new Turn(this);
        private ClassLoader contextLoader;
        /** Others only compare it, so it need not be volatile. */
        private Strand mounted;

        Carrier() {
            super(null, null, "brickless carrier", stackBytes, false);
            setDaemon(true);
            contextLoader = getContextClassLoader();
            carriers.add(this);
        }

        void receive(Strand strand) {
            mounted = strand;
            if (contextLoader != strand.contextLoader) {
                contextLoader = strand.contextLoader;
                setContextClassLoader(contextLoader);
            }
        }

        @Override
        public void run() {
            try {
                turn.await();
                runFibres();
            } catch (Throwable e) {
                onFailure.accept(e);
            } finally {
                carriers.remove(this);
            }
        }

        private void runFibres() {
            while (!ended) {
                if (next == null) {
                    endRun();
                    return;
                }
                Strand strand = strandOf(next);
                if (strand.pinnedTo == null) {
                    strand.mount(this);
                } else {
                    idle.push(this);
                    give(strand.pinnedTo);
                    turn.await();
                }
            }
        }
    }
}
