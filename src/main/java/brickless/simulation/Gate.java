package brickless.simulation;

import java.util.ArrayDeque;
import java.util.Queue;

/**
 * Holds a run at a physics step until whoever drives it lets it go on.
 *
 * <p>Two host threads meet here, and only here: the driver (a test, the command line) and the run. While the run is
 * held the driver may read the robots' state and leave actions to be done when the run goes on. Guarded by this
 * object's monitor.
 */
final class Gate {
    private final Queue<Runnable> actions = new ArrayDeque<>();
    /** Written with the monitor held; the run also looks at it without. */
    private volatile long openUntilNanos;
    private boolean held;
    private long heldAtNanos;
    private boolean ended;
    private Throwable failure;

    /** Run: passes the gate, waiting if it is closed at this time, and does what was left to do. */
    void pass(long nowNanos) {
        if (nowNanos >= openUntilNanos) {
            await(nowNanos);
        }
    }

    private synchronized void await(long nowNanos) {
        held = true;
        heldAtNanos = nowNanos;
        notifyAll();
        boolean interrupted = false;
        while (nowNanos >= openUntilNanos) {
            try {
                wait();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        held = false;
        for (Runnable action = actions.poll(); action != null; action = actions.poll()) {
            action.run();
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Run: it is over. */
    synchronized void end(Throwable problem) {
        ended = true;
        failure = problem;
        notifyAll();
    }

    /**
     * Driver: lets the run go on until a time and waits until it gets there or ends.
     *
     * @return false if the driver was interrupted: the run is then held as soon as possible
     */
    synchronized boolean advanceTo(long timeNanos) {
        openUntilNanos = Math.max(openUntilNanos, timeNanos);
        if (held && openUntilNanos <= heldAtNanos) {
            return true;
        }
        held = false;
        notifyAll();
        boolean interrupted = false;
        while (!held && !ended) {
            try {
                wait();
            } catch (InterruptedException e) {
                interrupted = true;
                openUntilNanos = 0;
            }
        }
        throwFailure();
        return !interrupted;
    }

    private void throwFailure() {
        if (failure instanceof RuntimeException exception) {
            throw exception;
        }
        if (failure instanceof Error error) {
            throw error;
        }
    }

    /** Driver: leaves something to be done, in the run's thread, when it goes on. */
    synchronized void leave(Runnable action) {
        actions.add(action);
    }

    synchronized boolean ended() {
        return ended;
    }
}
