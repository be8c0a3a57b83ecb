package brickless.kernel;

import brickless.kernel.hooks.Budget;
import java.util.List;

/**
 * One virtual processor: decides which fibre runs, when it loses the processor, and lets the clock jump while all
 * wait.
 *
 * <p>Runs on the running fibre's stack and nowhere else. A fibre that blocks while no other is ready drives the clock
 * itself until something is ready; if that is the same fibre, it just goes on and no stack is switched.
 */
final class Scheduler {
    private final VirtualClock clock;
    private final Ending ending;
    private final Schedule schedule;
    private final Roster roster;
    private final DeadlockDetector deadlocks;
    private FibreQueue ready = new FibreQueue();
    private KernelListener listener = new KernelListener() { };
    private Backend backend;
    private Heartbeat heartbeat;
    private Fibre current;
    /**
     * When another ready fibre gets its turn; a fibre that outlives its slice alone is preempted as soon as another
     * is ready.
     */
    private long sliceEnd;
    private long switches;
    /**
     * Time-outs that are set, plus fibres that wait for a device: if none, nobody blocked can be woken from outside.
     */
    private int wakeable;

    Scheduler(VirtualClock clock, Ending ending, Schedule schedule, Roster roster) {
        this.clock = clock;
        this.ending = ending;
        this.schedule = schedule;
        this.roster = roster;
        this.deadlocks = new DeadlockDetector(this, clock, ending, roster);
    }

    void listen(KernelListener newListener) {
        listener = newListener;
    }

    void attach(Backend newBackend, Heartbeat newHeartbeat) {
        backend = newBackend;
        heartbeat = newHeartbeat;
    }

    Fibre current() {
        return current;
    }

    Backend backend() {
        return backend;
    }

    long switches() {
        return switches;
    }

    /** Checks that the caller may block or be charged, and that the program is not being ended. */
    void enter() {
        ending.throwIfKilling();
        if (clock.advancing()) {
            throw new IllegalStateException("a physics step or event cannot charge or block");
        }
        heartbeat.beat();
    }

    /** Charges the running fibre; others may run before this returns. */
    void charge(long nanos) {
        if (!clock.spend(nanos)) {
            enter();
            clock.settle(nanos);
            ending.throwIfKilling();
            if (keepsProcessor() || clock.now() < sliceEnd) {
                grant();
            } else {
                preempt();
            }
        }
    }

    /** Lets the others run first. */
    void preempt() {
        makeReady(current);
        dispatch();
        ending.throwIfKilling();
    }

    /** {@code Thread.yield}: charges, the more the longer the fibre has made no progress. */
    void yieldProcessor() {
        long doubled = (long) Costs.YIELD_NANOS << Math.min(current.yields, Integer.SIZE);
        long nanos = Math.min(Costs.LONGEST_YIELD_NANOS, doubled);
        current.yields++;
        if (ready.isEmpty() && clock.spend(nanos)) {
            return;
        }
        enter();
        clock.settle(nanos);
        ending.throwIfKilling();
        if (keepsProcessor()) {
            grant();
        } else {
            preempt();
        }
    }

    /** The running fibre keeps the processor from the first such begin to the last end, unless it blocks. */
    void undivided(boolean begins) {
        if (current == null) {
            // Before the run, on the host.
            return;
        }
        current.undivided += begins ? 1 : -1;
        if (!keepsProcessor()) {
            clock.shorten(sliceEnd);
        }
    }

    /** Switches before a monitor is entered, if the schedule says so. */
    void preemptBeforeMonitor() {
        if (!keepsProcessor() && schedule.preemptsBeforeMonitor()) {
            enter();
            preempt();
        }
    }

    /**
     * Blocks the running fibre, which has been put where its waker will find it.
     *
     * @param timeoutNanos 0 = for ever
     */
    Wake block(FibreState state, long timeoutNanos) {
        enter();
        Fibre me = current;
        me.state = state;
        me.yields = 0;
        me.blocks++;
        if (timeoutNanos > 0) {
            clock.schedule(me.timeout, VirtualClock.saturatedSum(clock.now(), timeoutNanos));
            wakeable++;
        }
        if (state.waitsForDevice()) {
            wakeable++;
        }
        deadlocks.blocked(me);
        dispatch();
        ending.throwIfKilling();
        return me.wake;
    }

    /** Makes a blocked fibre ready; it leaves the queue it waits in. */
    void wake(Fibre fibre, Wake reason) {
        if (ending.killing()) {
            return;
        }
        if (fibre.queue != null) {
            fibre.queue.remove(fibre);
        }
        cancelTimeout(fibre);
        if (fibre.state.waitsForDevice()) {
            wakeable--;
        }
        fibre.wake = reason;
        makeReady(fibre);
        if (!clock.advancing()) {
            clock.shorten(sliceEnd);
        }
    }

    /** The time-out of a blocked fibre passed: it has left the event queue. */
    void timedOut(Fibre fibre) {
        wakeable--;
        wake(fibre, Wake.TIMED_OUT);
    }

    void cancelTimeout(Fibre fibre) {
        if (fibre.timeout.queued()) {
            clock.cancel(fibre.timeout);
            wakeable--;
        }
    }

    /** Takes a new fibre in; it runs when its turn comes. */
    void admit(Fibre fibre) {
        backend.create(fibre);
        listener.started(clock.now(), fibre.thread);
        makeReady(fibre);
        if (current != null) {
            clock.shorten(sliceEnd);
        }
    }

    /** Makes the first fibre the running one; the back-end will enter it. */
    void begin() {
        activate(ready.poll());
    }

    /** Stops the budget, so that the next back-edge enters the kernel and finds the program being ended. */
    void exhaustBudget() {
        clock.settle(0);
    }

    /** Lets go of the program after the run. */
    void release() {
        current = null;
        ready = new FibreQueue();
        backend = null;
    }

    /** What runs after the running fibre has ended, already made current; null if the program is over. */
    Fibre successor() {
        Fibre next = next();
        if (next != null) {
            activate(next);
        }
        return next;
    }

    private void makeReady(Fibre fibre) {
        fibre.state = FibreState.READY;
        ready.addLast(fibre);
    }

    /** The running fibre gave the processor up: runs others until it is chosen again. */
    private void dispatch() {
        Fibre me = current;
        Fibre next = next();
        if (next == me) {
            activate(me);
            return;
        }
        me.depth = clock.budget().depth();
        activate(next);
        switches++;
        backend.switchTo(me, next);
    }

    private Fibre next() {
        clock.settle(0);
        while (!ending.killing()) {
            if (!ready.isEmpty()) {
                return schedule.next(ready);
            }
            heartbeat.beat();
            if (wakeable == 0 || !clock.limited() && clock.nextDueNanos() == Long.MAX_VALUE) {
                deadlocks.declare();
            } else {
                clock.jump();
            }
        }
        return nextToUnwind();
    }

    private void activate(Fibre fibre) {
        if (fibre != current) {
            clock.budget().depth(fibre.depth);
        }
        current = fibre;
        fibre.begun = true;
        fibre.state = FibreState.RUNNING;
        beginSlice();
        if (!ending.killing()) {
            listener.scheduled(clock.now(), fibre.id);
        }
    }

    /** The oldest fibre that has a stack; those that never ran just vanish. */
    private Fibre nextToUnwind() {
        List<Fibre> live = roster.live();
        for (Fibre fibre : live) {
            if (fibre.begun && !fibre.ended()) {
                if (fibre.queue != null) {
                    fibre.queue.remove(fibre);
                }
                return fibre;
            }
        }
        return null;
    }

    private void beginSlice() {
        sliceEnd = VirtualClock.saturatedSum(clock.now(), schedule.sliceNanos());
        grant();
    }

    private void grant() {
        if (ending.killing()) {
            clock.grantUntil(0);
        } else {
            clock.grantUntil(keepsProcessor() ? Long.MAX_VALUE : sliceEnd);
        }
    }

    private boolean keepsProcessor() {
        return ready.isEmpty() || current != null && current.undivided > 0;
    }
}
