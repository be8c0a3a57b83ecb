package brickless.kernel;

import brickless.kernel.hooks.Budget;

/**
 * Virtual time of one robot. It passes only by spending the budget that rewritten code counts down, and by jumps
 * while all threads wait.
 *
 * <p>Time now = {@code base} + what was granted − what is left. The grant never reaches beyond the next event, so
 * nothing that is due can be missed; what is overdue by the last charge runs, with the clock set to its own time, at
 * the next kernel entry and before any device can be touched. Used by the running fibre only, and at physics steps by
 * whoever has the host's turn.
 */
final class VirtualClock {
    private static final long LONGEST_GRANT_NANOS = 1_000_000_000L;

    private final EventQueue events = new EventQueue();
    private final Ending ending;
    private final long stepNanos;
    private final long limitNanos;
    private Budget budget;
    private long base;
    private long granted;
    /** Where {@link #advance} is going. */
    private long goal;
    private long nextStepNanos = Long.MAX_VALUE;
    private long steps;
    private boolean advancing;

    VirtualClock(KernelSettings settings, Ending ending) {
        this.ending = ending;
        this.stepNanos = settings.stepNanos();
        this.limitNanos = settings.limitNanos();
    }

    void bind(Budget newBudget) {
        budget = newBudget;
        granted = 0;
        budget.grant(0);
    }

    /** Makes the clock stop at each multiple of the step length. */
    void stopAtSteps() {
        nextStepNanos = (steps + 1) * stepNanos;
    }

    Budget budget() {
        return budget;
    }

    long steps() {
        return steps;
    }

    long now() {
        return base + granted - budget.left();
    }

    /** Whether a step or an event runs now, which must neither charge nor block. */
    boolean advancing() {
        return advancing;
    }

    /** Spends time out of the budget if enough is left. */
    boolean spend(long nanos) {
        int left = budget.left();
        if (nanos >= left) {
            return false;
        }
        if (nanos < 0) {
            throw new IllegalArgumentException("negative charge: " + nanos + " ns");
        }
        budget.grant(left - (int) nanos);
        return true;
    }

    /** Spends time without looking whether something is due; the next kernel entry will. */
    void spendUnseen(int nanos) {
        budget.grant(budget.left() - nanos);
    }

    /** Sets out for now + {@code nanos}: {@link #advance} gets there. */
    void headFor(long nanos) {
        exhaust();
        goal = Math.min(saturatedSum(base, nanos), limitNanos);
        advancing = true;
    }

    /** Sets out for the next event or step, or for the limit. */
    void headForNextDue() {
        exhaust();
        goal = Math.min(Math.max(base, nextDueNanos()), limitNanos);
        advancing = true;
    }

    /**
     * Brings the clock to where it is headed, running all that is due on the way; ends early when the program is being
     * ended.
     *
     * @return false if the clock stopped at a physics step: to be called again when the world has been stepped
     */
    boolean advance() {
        while (!ending.killing()) {
            long due = nextDueNanos();
            if (due > goal || due == Long.MAX_VALUE) {
                arrive();
                break;
            }
            if (due == nextStepNanos) {
                base = due;
                nextStepNanos += stepNanos;
                steps++;
                return false;
            }
            runNextEvent();
        }
        advancing = false;
        return true;
    }

    /** Takes back what is left of the grant: the program enters the kernel at its next charge. */
    void exhaust() {
        base = now();
        granted = 0;
        budget.grant(0);
    }

    /** Time of the next step or event, {@code Long.MAX_VALUE} if there is none. */
    long nextDueNanos() {
        return Math.min(nextStepNanos, events.nextTimeNanos());
    }

    boolean limited() {
        return limitNanos != Long.MAX_VALUE;
    }

    /** Grants the budget until something is due, at most until {@code timeNanos}. */
    void grantUntil(long timeNanos) {
        long now = now();
        long until = Math.min(Math.min(timeNanos, limitNanos), nextDueNanos());
        granted = Math.max(0, Math.min(LONGEST_GRANT_NANOS, until - now));
        base = now;
        budget.grant((int) granted);
    }

    /** Makes rewritten code enter the kernel at {@code timeNanos} at the latest. */
    void shorten(long timeNanos) {
        int left = budget.left();
        long allowed = Math.max(0, timeNanos - now());
        if (allowed < left) {
            granted -= left - allowed;
            budget.grant((int) allowed);
        }
    }

    /** Queues an event; a time that has passed means now. */
    void schedule(Event event, long timeNanos) {
        events.add(event, Math.max(timeNanos, base));
        shorten(timeNanos);
    }

    void cancel(Event event) {
        events.remove(event);
    }

    void clear() {
        events.clear();
        nextStepNanos = Long.MAX_VALUE;
    }

    static long saturatedSum(long time, long nanos) {
        return nanos > Long.MAX_VALUE - time ? Long.MAX_VALUE : time + nanos;
    }

    private void arrive() {
        base = goal;
        if (goal == limitNanos && limited()) {
            ending.kill(ProgramEnd.Kind.TIME_LIMIT, goal, 0, "");
        }
    }

    private void runNextEvent() {
        Event event = events.poll();
        base = event.timeNanos;
        try {
            event.run();
        } catch (RuntimeException | Error e) {
            ending.hostFailed(e, base);
        }
    }
}
