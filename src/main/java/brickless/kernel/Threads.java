package brickless.kernel;

import java.util.List;

/** What {@code java.lang.Thread} and {@code LockSupport} do, on fibres. */
final class Threads {
    private final Scheduler scheduler;
    private final VirtualClock clock;
    private final Ending ending;
    private final Roster roster;
    private final int maximum;

    Threads(Scheduler scheduler, VirtualClock clock, Ending ending, Roster roster, int maximum) {
        this.scheduler = scheduler;
        this.clock = clock;
        this.ending = ending;
        this.roster = roster;
        this.maximum = maximum;
    }

    /** Refuses a thread that was started before, or one too many. */
    void checkStartable(Thread thread) {
        if (roster.of(thread) != null) {
            throw new IllegalThreadStateException();
        }
        if (roster.live().size() >= maximum) {
            throw new OutOfMemoryError("unable to create new native thread: " + maximum + " threads are alive");
        }
    }

    void sleep(long nanos) throws InterruptedException {
        checkTimeout(nanos);
        ending.throwIfKilling();
        Fibre me = scheduler.current();
        if (me.takeInterrupt()) {
            throw new InterruptedException("sleep interrupted");
        }
        if (nanos == 0) {
            scheduler.yieldProcessor();
        } else if (scheduler.block(FibreState.SLEEPING, nanos) == Wake.INTERRUPTED && me.takeInterrupt()) {
            throw new InterruptedException("sleep interrupted");
        }
    }

    void join(Thread thread, long nanos) throws InterruptedException {
        checkTimeout(nanos);
        scheduler.enter();
        Fibre target = roster.of(thread);
        if (target == null || target.ended()) {
            return;
        }
        Fibre me = scheduler.current();
        if (me.takeInterrupt()) {
            throw new InterruptedException();
        }
        me.joined = target;
        target.joiners.addLast(me);
        Wake reason = scheduler.block(FibreState.JOINING, nanos);
        me.joined = null;
        if (reason == Wake.INTERRUPTED && me.takeInterrupt()) {
            throw new InterruptedException();
        }
    }

    void interrupt(Thread thread) {
        Fibre fibre = roster.of(thread);
        if (fibre == null || fibre.ended()) {
            return;
        }
        fibre.interrupted = true;
        if (fibre.state.interruptible()) {
            scheduler.wake(fibre, Wake.INTERRUPTED);
        }
    }

    boolean interrupted(Thread thread, boolean clear) {
        Fibre fibre = roster.of(thread);
        if (fibre == null || fibre.ended()) {
            return false;
        }
        return clear ? fibre.takeInterrupt() : fibre.interrupted;
    }

    void park(long nanos) {
        scheduler.enter();
        Fibre me = scheduler.current();
        if (me.permit) {
            me.permit = false;
        } else if (!me.interrupted) {
            scheduler.block(FibreState.PARKED, Math.max(0, nanos));
        }
    }

    void unpark(Thread thread) {
        Fibre fibre = roster.of(thread);
        if (fibre == null || fibre.ended()) {
            return;
        }
        if (fibre.state == FibreState.PARKED) {
            scheduler.wake(fibre, Wake.RESUMED);
        } else {
            fibre.permit = true;
        }
    }

    boolean isAlive(Thread thread) {
        Fibre fibre = roster.of(thread);
        return fibre != null && !fibre.ended();
    }

    Thread.State state(Thread thread) {
        Fibre fibre = roster.of(thread);
        return fibre == null ? Thread.State.NEW : fibre.threadState();
    }

    Thread[] live() {
        List<Fibre> live = roster.live();
        Thread[] threads = new Thread[live.size()];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = live.get(i).thread;
        }
        return threads;
    }

    /** Marks a fibre as ended and lets those go on that waited for it. */
    void ended(Fibre fibre) {
        fibre.state = FibreState.ENDED;
        roster.ended(fibre);
        for (Fibre joiner = fibre.joiners.poll(); joiner != null; joiner = fibre.joiners.poll()) {
            scheduler.wake(joiner, Wake.RESUMED);
        }
    }

    private static void checkTimeout(long nanos) {
        if (nanos < 0) {
            throw new IllegalArgumentException("timeout value is negative");
        }
    }
}
