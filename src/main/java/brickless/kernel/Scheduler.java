package brickless.kernel;

import java.util.List;

/**
 * One virtual processor: decides which fibre runs, when it loses the processor, and lets the clock jump while all
 * wait.
 *
 * <p>What is asked of it by the running fibre runs on that one's stack. All else, {@link #proceed}, needs no stack of
 * the program: a fibre that gives the processor up drives its own clock, and at a physics step those of the other
 * robots, until a fibre is found that goes on. If that is the same one, no stack is switched; no stack is entered in
 * vain.
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
    private Turns turns;
    private Fibre current;
    private Then then = Then.RUN;
    private boolean over;
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

    /** What is decided when the clock has got to where it is headed. */
    private enum Then {
        /** Nothing: the current fibre runs. */
        RUN,
        /** Whether the current fibre, which was charged, keeps the processor. */
        CHARGED,
        /** Whether the current fibre, which yielded, keeps the processor. */
        YIELDED,
        /** Who runs next; the current fibre is blocked, ready or ended. */
        CHOOSE
    }

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

    void attach(Backend newBackend, Heartbeat newHeartbeat, Turns newTurns) {
        backend = newBackend;
        heartbeat = newHeartbeat;
        turns = newTurns;
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
            goOn(nanos, Then.CHARGED);
        }
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
        goOn(nanos, Then.YIELDED);
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
            makeReady(current);
            goOn(0, Then.CHOOSE);
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
        goOn(0, Then.CHOOSE);
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

    /** Makes the first fibre the current one, to be entered when its turn comes. */
    void begin() {
        activate(ready.poll());
    }

    /** Stops the budget, so that the next back-edge enters the kernel and finds the program being ended. */
    void exhaustBudget() {
        clock.exhaust();
    }

    /** Lets go of the program after the run. */
    void release() {
        current = null;
        ready = new FibreQueue();
        backend = null;
        turns = null;
    }

    /** The running fibre has ended: whom the back-end goes on with, null if all programs are over. */
    Fibre successor() {
        clock.headFor(0);
        then = Then.CHOOSE;
        return turn();
    }

    /** Whether no fibre has a stack any more and none will. */
    boolean over() {
        return over;
    }

    /**
     * Goes on until it is known who runs next, and makes that fibre the current one. Needs no stack of its own: whoever
     * has the host's turn may call it.
     *
     * @return null when the clock has stopped at a physics step, to be called again when the world has been stepped; or
     *     when the program is over
     */
    Fibre proceed() {
        if (then == Then.RUN) {
            return current;
        }
        if (!clock.advance()) {
            return null;
        }
        if (then != Then.CHOOSE) {
            if (keepsItsTurn()) {
                grant();
                return current;
            }
            makeReady(current);
            then = Then.CHOOSE;
        }
        return choose();
    }

    private void makeReady(Fibre fibre) {
        fibre.state = FibreState.READY;
        ready.addLast(fibre);
    }

    /** Lets the clock advance by {@code nanos}; returns when the running fibre may go on. */
    private void goOn(long nanos, Then decision) {
        Fibre me = current;
        clock.headFor(nanos);
        then = decision;
        Fibre next = turn();
        if (next != me) {
            backend.switchTo(me, next);
        }
        ending.throwIfKilling();
    }

    /** The fibre to run now, of this program or another one's; null if all programs are over. */
    private Fibre turn() {
        Fibre own = proceed();
        return own != null ? own : turns.next();
    }

    private boolean keepsItsTurn() {
        return ending.killing() || keepsProcessor() || then == Then.CHARGED && clock.now() < sliceEnd;
    }

    private Fibre choose() {
        while (!ending.killing()) {
            if (!ready.isEmpty()) {
                return activate(schedule.next(ready));
            }
            heartbeat.beat();
            if (wakeable == 0 || !clock.limited() && clock.nextDueNanos() == Long.MAX_VALUE) {
                deadlocks.declare();
            } else {
                clock.headForNextDue();
                if (!clock.advance()) {
                    return null;
                }
            }
        }
        Fibre unwound = nextToUnwind();
        over = unwound == null;
        return over ? null : activate(unwound);
    }

    private Fibre activate(Fibre fibre) {
        if (current != null && fibre != current) {
            current.depth = clock.budget().depth();
            clock.budget().depth(fibre.depth);
            switches += current.ended() ? 0 : 1;
        }
        current = fibre;
        fibre.begun = true;
        fibre.state = FibreState.RUNNING;
        beginSlice();
        if (!ending.killing()) {
            listener.scheduled(clock.now(), fibre.id);
        }
        return fibre;
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
