package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** {@code java.util.concurrent.CyclicBarrier} on virtual monitors. */
public class CyclicBarrier {
    private final Object monitor = new Object();
    private final int parties;
    private final Runnable action;
    private Round round = new Round();

    /** One use of the barrier; guarded by the monitor. */
    private static final class Round {
        int arrived;
        boolean tripped;
        boolean broken;
    }

    /** Creates a barrier for {@code parties} threads; IllegalArgumentException if there is none. */
    public CyclicBarrier(int parties) {
        this(parties, null);
    }

    /** Creates a barrier whose last arriving thread runs {@code barrierAction} (if not null) before all go on. */
    public CyclicBarrier(int parties, Runnable barrierAction) {
        if (parties <= 0) {
            throw new IllegalArgumentException("parties <= 0");
        }
        this.parties = parties;
        this.action = barrierAction;
    }

    /** Number of threads that trip the barrier. */
    public int getParties() {
        return parties;
    }

    /** Waits for all parties; returns how many were still missing when this thread arrived. */
    public int await() throws InterruptedException, BrokenBarrierException {
        try {
            return await(Deadline.NEVER);
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    /** Waits for all parties; when the time passes first, breaks the barrier and throws TimeoutException. */
    public int await(long timeout, TimeUnit unit)
            throws InterruptedException, BrokenBarrierException, TimeoutException {
        return await(Deadline.after(timeout, unit));
    }

    private int await(Deadline deadline) throws InterruptedException, BrokenBarrierException, TimeoutException {
        synchronized (monitor) {
            Round mine = round;
            failIfBroken(mine);
            if (Thread.interrupted()) {
                breakRound(mine);
                throw new InterruptedException();
            }
            mine.arrived++;
            int missing = parties - mine.arrived;
            if (missing == 0) {
                trip(mine);
            } else {
                awaitTrip(mine, deadline);
            }
            return missing;
        }
    }

    private void trip(Round mine) {
        boolean done = false;
        try {
            if (action != null) {
                action.run();
            }
            done = true;
        } finally {
            if (done) {
                mine.tripped = true;
                round = new Round();
                monitor.notifyAll();
            } else {
                breakRound(mine);
            }
        }
    }

    private void awaitTrip(Round mine, Deadline deadline)
            throws InterruptedException, BrokenBarrierException, TimeoutException {
        while (!mine.tripped) {
            failIfBroken(mine);
            boolean inTime;
            try {
                inTime = deadline.await(monitor);
            } catch (InterruptedException e) {
                if (mine.tripped || mine.broken) {
                    // The round ended first; the interrupt belongs to whatever the thread does next.
                    Thread.currentThread().interrupt();
                    continue;
                }
                breakRound(mine);
                throw e;
            }
            if (!inTime) {
                breakRound(mine);
                throw new TimeoutException();
            }
        }
    }

    private static void failIfBroken(Round mine) throws BrokenBarrierException {
        if (mine.broken) {
            throw new BrokenBarrierException();
        }
    }

    private void breakRound(Round mine) {
        mine.broken = true;
        mine.arrived = 0;
        monitor.notifyAll();
    }

    /** Whether an interrupt, a time-out, a reset or a failed action broke the barrier. */
    public boolean isBroken() {
        synchronized (monitor) {
            return round.broken;
        }
    }

    /** Breaks the barrier for the threads that wait and makes it whole again. */
    public void reset() {
        synchronized (monitor) {
            breakRound(round);
            round = new Round();
        }
    }

    /** Number of threads that wait at the barrier. */
    public int getNumberWaiting() {
        synchronized (monitor) {
            return round.arrived;
        }
    }
}
