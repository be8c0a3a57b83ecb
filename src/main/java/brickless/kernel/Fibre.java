package brickless.kernel;

import brickless.kernel.hooks.OwnedLock;
import java.util.function.Consumer;

/**
 * One program thread: a stack that the kernel switches to and from.
 *
 * <p>All fields belong to the running fibre of the same kernel; back-ends own {@link #stack}.
 */
final class Fibre {
    /** In order of starting, from 1. */
    final int id;
    final Thread thread;
    final boolean daemon;
    /** What JDK code finds as context class loader. */
    final ClassLoader contextLoader;
    final Event timeout;
    /** Fibres that wait in {@code Thread.join} for this one. */
    final FibreQueue joiners = new FibreQueue();
    private final Consumer<Fibre> body;

    FibreState state = FibreState.READY;
    Wake wake = Wake.RESUMED;
    boolean interrupted;
    /** Of {@code LockSupport}. */
    boolean permit;
    /** Whether the fibre ever ran, so that there is a stack to unwind. */
    boolean begun;
    /** Yields since the last progress. */
    int yields;
    /** Call depth while another fibre runs. */
    int depth;
    /** Static initialisers that only compute on the fibre's stack: it keeps the processor until they end. */
    int undivided;
    /** How often the fibre blocked. */
    long blocks;
    /** The monitor waited for or in, while BLOCKED or WAITING. */
    Monitor monitor;
    /** How often the fibre was woken for that monitor and found it taken. */
    int bypassed;
    /** The lock, built on monitors, that the fibre waits for in whatever it does now; null for none. */
    OwnedLock blocker;
    /** The fibre waited for, while JOINING. */
    Fibre joined;

    /** The queue the fibre is in, and its neighbours there. */
    FibreQueue queue;
    Fibre previous;
    Fibre next;

    /** What the back-end keeps for this fibre. */
    Object stack;

    Fibre(int id, Thread thread, ClassLoader contextLoader, Consumer<Fibre> body, Consumer<Fibre> onTimeout) {
        this.id = id;
        this.thread = thread;
        this.daemon = thread.isDaemon();
        this.contextLoader = contextLoader;
        this.body = body;
        this.timeout = new Event(() -> onTimeout.accept(this));
    }

    /** What the fibre's stack executes, once. */
    void run() {
        body.accept(this);
    }

    boolean ended() {
        return state == FibreState.ENDED;
    }

    Thread.State threadState() {
        return state.threadState(timeout.queued());
    }

    /** Reads the interrupt flag and clears it. */
    boolean takeInterrupt() {
        boolean was = interrupted;
        interrupted = false;
        return was;
    }
}
