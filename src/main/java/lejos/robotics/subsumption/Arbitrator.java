package lejos.robotics.subsumption;

/**
 * Lets, of several behaviours, always the one of highest priority drive that wants to.
 *
 * <p><b>Two threads.</b> The caller of {@link #go} runs every {@link Behavior#action action}, one after another. A
 * daemon thread, the <i>monitor</i>, asks and tells: it alone calls {@link Behavior#takeControl takeControl} and {@link
 * Behavior#suppress suppress}. It works in passes, about 2 ms apart. In each pass it asks the behaviours above the
 * active one, from the top down, until one says yes; no one below that is asked. If one said yes and an action is
 * running, it calls suppress on the running behaviour: once per pass, as long as the action lasts and the wish does.
 *
 * <p><b>One lock.</b> The monitor holds it for a whole pass, so its calls never overlap one another. The thread in go
 * holds it only to choose; actions run without it, beside the passes. What is chosen is always the result of a whole
 * pass made after the last action returned, in which every behaviour could be heard. So a wish that has passed before
 * its turn came is forgotten, and a behaviour that still wants to drive when its action returns acts again, unless a
 * higher one wants to.
 *
 * <p>Nothing forces an action to end: a behaviour that ignores suppress keeps every other waiting.
 *
 * <p><b>Ends.</b> See {@link #go}. When it ends, whatever the reason, the monitor ends too. An arbitrator goes once
 * only.
 */
public class Arbitrator {
    /** No behaviour. */
    private static final int NONE = -1;

    /** No pass was made since the last action returned. */
    private static final int UNKNOWN = -2;

    /** Rest between passes: 500 passes a second notice any wish soon and leave the processor to the actions. */
    private static final long PAUSE_MILLIS = 2;

    /**
     * True until {@link #stop}; a program may also clear it itself. Read under the lock before each pass and each
     * choice, so that a change is seen at the next.
     */
    public boolean keepRunning = true;

    private final Behavior[] behaviors;
    private final boolean returnWhenInactive;
    private final ArbitrationReport report;
    private final Thread monitor;
    private final Object lock = new Object();

    // Guarded by lock.
    private int active = NONE;
    private int wanted = UNKNOWN;
    private boolean begun;
    private boolean watching = true;
    private Throwable failure;

    /**
     * An arbitrator; prints one line saying so.
     *
     * @param behaviorList behaviours, lowest priority first; not copied
     * @param returnWhenInactive whether {@link #go} returns when, after the first action, no behaviour wants to drive
     * @throws NullPointerException if the list is null
     */
    public Arbitrator(Behavior[] behaviorList, boolean returnWhenInactive) {
        this.behaviors = behaviorList;
        this.returnWhenInactive = returnWhenInactive;
        this.report = new ArbitrationReport(behaviorList);
        this.monitor = new Thread(this::watch, "arbitrator monitor");
        monitor.setDaemon(true);
        System.out.println("Arbitrator created");
    }

    /**
     * An arbitrator that waits for ever when no behaviour wants to drive; prints one line saying so.
     *
     * @param behaviorList behaviours, lowest priority first; not copied
     * @throws NullPointerException if the list is null
     */
    public Arbitrator(Behavior[] behaviorList) {
        this(behaviorList, false);
    }

    /**
     * Runs the behaviours' actions on this thread; waits first until some behaviour wants to drive.
     *
     * <p>Returns after {@link #stop}, or when no behaviour wants to drive any more if the constructor was told so; in
     * both cases not before the running action has returned. An exception that an action throws comes out of here at
     * once. One that takeControl or suppress throws ends the monitor and comes out of here when the running action has
     * returned; since that may be never, such a one also ends the monitor thread as an uncaught exception, which
     * reports it at once. Interrupting the caller has no effect here: the interrupt is kept for the next action.
     *
     * @throws IllegalThreadStateException if called a second time
     */
    public void go() {
        monitor.start();
        Throwable problem;
        try {
            for (int next = awaitChoice(); next != NONE; next = awaitChoice()) {
                behaviors[next].action();
            }
        } finally {
            problem = leave();
        }
        rethrow(problem);
    }

    /**
     * The same as {@link #go}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    public void start() {
        go();
    }

    /**
     * Ends arbitration: no behaviour is asked, told or started any more, and {@link #go} returns when the running
     * action does. Returns at once, and does not suppress that action.
     */
    public void stop() {
        keepRunning = false;
    }

    /** Waits until it is settled who acts next, and makes that one active; {@link #NONE} = go is to return. */
    private int awaitChoice() {
        synchronized (lock) {
            active = NONE;
            wanted = UNKNOWN;
            report.active(NONE);
            awaitSettled();
            if (!watching || !keepRunning || wanted == NONE) {
                return NONE;
            }
            begun = true;
            active = wanted;
            report.active(active);
            return active;
        }
    }

    /** Waits without giving in to interrupts, which belong to the program's actions. */
    private void awaitSettled() {
        boolean interrupted = false;
        while (!settled()) {
            try {
                lock.wait();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Whether the thread in go need not wait any longer; the monitor wakes it when this becomes true. */
    private boolean settled() {
        boolean idle = wanted == NONE && begun && returnWhenInactive;
        return idle || wanted >= 0 || !watching || !keepRunning;
    }

    /** The monitor's whole life. */
    private void watch() {
        try {
            while (pass()) {
                rest();
            }
        } catch (RuntimeException | Error problem) {
            if (failedInAction(problem)) {
                throw problem;
            }
        } finally {
            endWatch();
        }
    }

    /** Asks who wants to drive and suppresses the active behaviour for it; false = the monitor is to end. */
    private boolean pass() {
        synchronized (lock) {
            if (!watching || !keepRunning) {
                return false;
            }
            wanted = highestWish();
            report.wanted(wanted);
            if (active != NONE && wanted != NONE) {
                report.suppressed(active);
                behaviors[active].suppress();
            }
            if (settled()) {
                lock.notifyAll();
            }
            return true;
        }
    }

    /** The highest behaviour above the active one that wants to drive. */
    private int highestWish() {
        for (int i = behaviors.length - 1; i > active; i--) {
            if (behaviors[i].takeControl()) {
                return i;
            }
        }
        return NONE;
    }

    private static void rest() {
        try {
            Thread.sleep(PAUSE_MILLIS);
        } catch (InterruptedException e) {
            // A takeControl or suppress interrupted its own thread. That state is the program's: leave it, do not rest.
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Keeps what takeControl or suppress threw, for go to throw; true if that may be long because an action is running.
     */
    private boolean failedInAction(Throwable problem) {
        synchronized (lock) {
            failure = problem;
            return active != NONE;
        }
    }

    /** No action runs any more: ends the monitor with it. */
    private Throwable leave() {
        synchronized (lock) {
            active = NONE;
            report.active(NONE);
            return endWatch();
        }
    }

    /** Ends the monitor, if it has not ended, and the wait in go; returns why the monitor failed, if it did. */
    private Throwable endWatch() {
        synchronized (lock) {
            watching = false;
            lock.notifyAll();
            return failure;
        }
    }

    private static void rethrow(Throwable problem) {
        if (problem instanceof Error error) {
            throw error;
        }
        if (problem instanceof RuntimeException exception) {
            throw exception;
        }
    }
}
