package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * {@code java.util.concurrent.Phaser} on virtual monitors. All phasers of a tree are guarded by the root's monitor, and
 * phases are the root's.
 */
public class Phaser {
    private static final int MAX_PARTIES = 0xffff;

    private final Phaser parent;
    private final Phaser root;
    // Guarded by the root; phase and terminated are used in the root only:
    private int registered;
    private int arrived;
    private int phase;
    private boolean terminated;
    /** The root's phase in which the counts above were made. */
    private int countedPhase;

    /** Creates a phaser without parties. */
    public Phaser() {
        this(null, 0);
    }

    /** Creates a phaser with that many parties. */
    public Phaser(int parties) {
        this(null, parties);
    }

    /** Creates a phaser without parties below {@code parent}. */
    public Phaser(Phaser parent) {
        this(parent, 0);
    }

    /** Creates a phaser below {@code parent} (if not null); it counts there as one party while it has any. */
    public Phaser(Phaser parent, int parties) {
        if (parties < 0 || parties > MAX_PARTIES) {
            throw new IllegalArgumentException("Illegal number of parties");
        }
        this.parent = parent;
        this.root = parent == null ? this : parent.root;
        synchronized (root) {
            countedPhase = root.phase;
            if (parties > 0) {
                bulkRegister(parties);
            }
        }
    }

    /** Adds a party; returns the phase, negative when terminated. */
    public int register() {
        return bulkRegister(1);
    }

    /** Adds parties; returns the phase, negative when terminated. */
    public int bulkRegister(int parties) {
        if (parties < 0) {
            throw new IllegalArgumentException();
        }
        synchronized (root) {
            if (root.terminated || parties == 0) {
                return getPhase();
            }
            startPhase();
            if (registered + parties > MAX_PARTIES) {
                throw new IllegalStateException("Attempt to register more than " + MAX_PARTIES + " parties for "
                        + this);
            }
            if (registered == 0 && parent != null) {
                parent.register();
            }
            registered += parties;
            return getPhase();
        }
    }

    /** Counts of a phase that is over are void. */
    private void startPhase() {
        if (countedPhase != root.phase) {
            countedPhase = root.phase;
            arrived = 0;
        }
    }

    /** Arrives without waiting; returns the phase arrived at, negative when terminated. */
    public int arrive() {
        return arrive(false);
    }

    /** Arrives without waiting and leaves; returns the phase arrived at, negative when terminated. */
    public int arriveAndDeregister() {
        return arrive(true);
    }

    private int arrive(boolean leave) {
        synchronized (root) {
            int current = getPhase();
            if (current < 0) {
                return current;
            }
            startPhase();
            if (arrived >= registered) {
                throw new IllegalStateException("Attempted arrival of unregistered party for " + this);
            }
            if (leave) {
                registered--;
            } else {
                arrived++;
            }
            if (arrived == registered) {
                completed();
            }
            return current;
        }
    }

    /** All parties of this phaser have arrived. */
    private void completed() {
        if (parent != null) {
            parent.arrive(registered == 0);
        } else {
            terminated |= onAdvance(phase, registered);
            phase = phase + 1 & Integer.MAX_VALUE;
            notifyAll();
        }
    }

    /** Arrives and waits for the others; returns the next phase, negative when terminated. */
    public int arriveAndAwaitAdvance() {
        synchronized (root) {
            int arrivedAt = arrive();
            return arrivedAt < 0 ? arrivedAt : awaitAdvance(arrivedAt);
        }
    }

    /** Waits, even when interrupted, until that phase is over; returns the current one, negative when terminated. */
    public int awaitAdvance(int phase) {
        boolean interrupted = false;
        while (true) {
            try {
                int next = awaitAdvance(phase, Deadline.NEVER, !interrupted && Thread.interrupted());
                if (interrupted) {
                    Thread.currentThread().interrupt();
                }
                return next;
            } catch (TimeoutException e) {
                throw new AssertionError(e);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
    }

    /** Waits until that phase is over; returns the current one, negative when terminated. */
    public int awaitAdvanceInterruptibly(int phase) throws InterruptedException {
        try {
            return awaitAdvance(phase, Deadline.NEVER, Thread.interrupted());
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    /** Waits at most that long until that phase is over; returns the current one, negative when terminated. */
    public int awaitAdvanceInterruptibly(int phase, long timeout, TimeUnit unit)
            throws InterruptedException, TimeoutException {
        return awaitAdvance(phase, Deadline.after(timeout, unit), Thread.interrupted());
    }

    private int awaitAdvance(int phase, Deadline deadline, boolean interrupted)
            throws InterruptedException, TimeoutException {
        synchronized (root) {
            if (phase < 0) {
                return phase;
            }
            while (getPhase() == phase) {
                if (interrupted) {
                    throw new InterruptedException();
                }
                if (!deadline.await(root)) {
                    throw new TimeoutException();
                }
            }
            return getPhase();
        }
    }

    /** Ends the phaser: nobody waits any more. */
    public void forceTermination() {
        synchronized (root) {
            root.terminated = true;
            root.notifyAll();
        }
    }

    /** The phase, from 0 to Integer.MAX_VALUE; negative when terminated. */
    public final int getPhase() {
        synchronized (root) {
            return root.terminated ? root.phase | Integer.MIN_VALUE : root.phase;
        }
    }

    /** Number of parties. */
    public int getRegisteredParties() {
        synchronized (root) {
            return registered;
        }
    }

    /** Number of parties that have arrived. */
    public int getArrivedParties() {
        synchronized (root) {
            return countedPhase == root.phase ? arrived : 0;
        }
    }

    /** Number of parties that have not arrived. */
    public int getUnarrivedParties() {
        synchronized (root) {
            return registered - getArrivedParties();
        }
    }

    /** The phaser above, or null. */
    public Phaser getParent() {
        return parent;
    }

    /** The phaser at the top. */
    public Phaser getRoot() {
        return root;
    }

    /** Whether the phaser has ended. */
    public boolean isTerminated() {
        synchronized (root) {
            return root.terminated;
        }
    }

    /** Called by the party that arrives last; true ends the phaser, which by default happens when no party is left. */
    protected boolean onAdvance(int phase, int registeredParties) {
        return registeredParties == 0;
    }

    @Override
    public String toString() {
        synchronized (root) {
            return super.toString() + "[phase = " + getPhase() + " parties = " + getRegisteredParties() + " arrived = "
                    + getArrivedParties() + "]";
        }
    }
}
