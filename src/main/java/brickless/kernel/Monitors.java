package brickless.kernel;

import java.util.Objects;

/**
 * Virtual {@code synchronized}, {@code wait} and {@code notify}.
 *
 * <p>Leaving a monitor wakes the first entrant but leaves the monitor free: whoever runs first gets it (direct
 * hand-over at every exit makes threads march in convoys). An entrant that lost {@value #LONGEST_BYPASS} times is
 * handed the monitor, so that nobody starves.
 */
final class Monitors {
    /** Assumption: on a brick, jitter lets a waiting thread in after a few attempts. */
    static final int LONGEST_BYPASS = 4;

    private final Scheduler scheduler;
    private final VirtualClock clock;
    private final Ending ending;
    private final MonitorTable table = new MonitorTable();

    Monitors(Scheduler scheduler, VirtualClock clock, Ending ending) {
        this.scheduler = scheduler;
        this.clock = clock;
        this.ending = ending;
    }

    void enter(Object lock) {
        Objects.requireNonNull(lock);
        ending.throwIfKilling();
        scheduler.preemptBeforeMonitor();
        clock.spendUnseen(Costs.MONITOR_ENTER_NANOS);
        Monitor monitor = table.findOrAdd(lock);
        Fibre me = scheduler.current();
        if (monitor.owner == null) {
            monitor.owner = me;
            monitor.count = 1;
        } else if (monitor.owner == me) {
            monitor.count++;
        } else {
            monitor.users++;
            acquire(monitor, 1);
            monitor.users--;
        }
    }

    /**
     * Never switches; while the program is being ended it does nothing, as what it would release may be held by
     * anybody.
     */
    void exit(Object lock) {
        if (ending.killing()) {
            return;
        }
        Monitor monitor = owned(lock);
        if (--monitor.count == 0) {
            release(monitor);
        }
    }

    void await(Object lock, long nanos) throws InterruptedException {
        if (nanos < 0) {
            throw new IllegalArgumentException("timeout value is negative");
        }
        scheduler.enter();
        Monitor monitor = owned(lock);
        Fibre me = scheduler.current();
        if (me.takeInterrupt()) {
            throw new InterruptedException();
        }
        int count = monitor.count;
        monitor.users++;
        release(monitor);
        monitor.waiters.addLast(me);
        me.monitor = monitor;
        Wake reason = scheduler.block(FibreState.WAITING, nanos);
        acquire(monitor, count);
        monitor.users--;
        if (reason == Wake.INTERRUPTED && me.takeInterrupt()) {
            throw new InterruptedException();
        }
    }

    /** Moves one waiter, or all, to the entrants; they are woken when the monitor is left. */
    void notify(Object lock, boolean all) {
        if (ending.killing()) {
            return;
        }
        notify(owned(lock), all);
    }

    boolean holds(Object lock) {
        Monitor monitor = table.find(Objects.requireNonNull(lock));
        return monitor != null && monitor.owner == scheduler.current();
    }

    /** A thread has ended: like in the JVM, whoever waits in its monitor is notified. */
    void threadEnded(Thread thread) {
        Monitor monitor = table.find(thread);
        if (monitor != null) {
            notify(monitor, true);
            if (monitor.owner == null) {
                wakeEntrant(monitor);
            }
        }
    }

    /** Monitors that somebody owns, wants or waits in. */
    int size() {
        return table.size();
    }

    void clear() {
        table.clear();
    }

    private Monitor owned(Object lock) {
        Monitor monitor = table.find(Objects.requireNonNull(lock));
        if (monitor == null || monitor.owner != scheduler.current()) {
            throw new IllegalMonitorStateException("current thread is not owner");
        }
        return monitor;
    }

    private void notify(Monitor monitor, boolean all) {
        Fibre waiter = monitor.waiters.poll();
        while (waiter != null) {
            scheduler.cancelTimeout(waiter);
            waiter.state = FibreState.BLOCKED;
            monitor.entrants.addLast(waiter);
            waiter = all ? monitor.waiters.poll() : null;
        }
    }

    /** Blocks until the running fibre owns the monitor. */
    private void acquire(Monitor monitor, int count) {
        Fibre me = scheduler.current();
        me.monitor = monitor;
        int lost = 0;
        while (monitor.owner != null && monitor.owner != me) {
            if (monitor.woken == me) {
                monitor.woken = null;
                lost++;
                monitor.entrants.addFirst(me);
            } else {
                monitor.entrants.addLast(me);
            }
            me.bypassed = lost;
            scheduler.block(FibreState.BLOCKED, 0);
        }
        if (monitor.woken == me) {
            monitor.woken = null;
        }
        me.monitor = null;
        me.bypassed = 0;
        monitor.owner = me;
        monitor.count = count;
    }

    private void release(Monitor monitor) {
        monitor.owner = null;
        if (monitor.idle()) {
            table.remove(monitor);
        } else {
            wakeEntrant(monitor);
        }
    }

    private void wakeEntrant(Monitor monitor) {
        if (monitor.woken != null) {
            return;
        }
        Fibre entrant = monitor.entrants.poll();
        if (entrant != null) {
            if (entrant.bypassed >= LONGEST_BYPASS) {
                monitor.owner = entrant;
            }
            monitor.woken = entrant;
            scheduler.wake(entrant, Wake.RESUMED);
        }
    }
}
