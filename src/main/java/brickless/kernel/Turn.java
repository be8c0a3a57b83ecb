package brickless.kernel;

import java.util.concurrent.locks.LockSupport;

/**
 * Lets one host thread wait until another one hands it the turn; the hand-over orders all memory accesses before and
 * after it.
 */
final class Turn {
    private final Thread thread;
    /** Touched by the giver only, who has the turn. */
    private boolean begun;
    private volatile boolean given;
    private volatile boolean released;
    private volatile boolean parked;

    Turn(Thread thread) {
        this.thread = thread;
    }

    /** Hands the turn over; starts the thread when this is its first one. */
    void give() {
        given = true;
        if (!begun) {
            begun = true;
            thread.start();
        } else if (parked) {
            LockSupport.unpark(thread);
        }
    }

    /** Lets the thread go without the turn, now and at every later wait. From any thread. */
    void release() {
        released = true;
        LockSupport.unpark(thread);
    }

    boolean given() {
        return given;
    }

    /** Waits for the turn; called by the thread itself. */
    void await() {
        parked = true;
        while (!given && !released) {
            LockSupport.park(this);
            // An interrupt of the host's would let park return for ever.
            Thread.interrupted();
        }
        parked = false;
        given = false;
    }
}
