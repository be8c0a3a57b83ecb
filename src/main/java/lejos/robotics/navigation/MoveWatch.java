package lejos.robotics.navigation;

import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import lejos.utility.Delay;

/**
 * Sees the moves of a pilot through, one after the other: tells the listeners of the start, waits on a daemon thread
 * until the robot is at rest, and tells them there of the stop. A stall ends a move as well.
 *
 * <p>A move is over when all listeners have been told. Only then the next one begins, so that nothing gets lost between
 * two moves. Listeners may themselves stop the robot or begin a move: those who were not told yet are told first.
 *
 * <p>This object's lock guards what is in progress. It is not held while listeners or motors are called.
 */
final class MoveWatch {
    private static final long PAUSE_MILLIS = 1;

    private final MoveProvider pilot;
    private final Drive drive;
    private final List<MoveListener> listeners = new CopyOnWriteArrayList<>();

    // Guarded by this.
    private WatchedMove current;
    private Stop stop;
    private Thread watcher;

    MoveWatch(MoveProvider pilot, Drive drive) {
        this.pilot = pilot;
        this.drive = drive;
    }

    /** What is watched. */
    interface Drive {
        /** Whether a motor moves. */
        boolean isMoving();

        /** Whether a motor is stalled. */
        boolean isStalled();

        /** Begins to slow down to rest. */
        void halt();

        /** What was done since the present move began. */
        Move done(Move plan);
    }

    /** The end of a move, of which some listeners know. */
    private record Stop(WatchedMove move, Move result, Iterator<MoveListener> listeners) {
        void tell(MoveProvider provider) {
            while (listeners.hasNext()) {
                listeners.next().moveStopped(result, provider);
            }
        }
    }

    void addListener(MoveListener listener) {
        listeners.add(listener);
    }

    /** Whether a move is in progress. */
    synchronized boolean isActive() {
        return current != null;
    }

    /** What was done of the move in progress, or of the one that listeners are being told of; else a STOP. */
    Move progress() {
        WatchedMove move;
        synchronized (this) {
            if (current == null) {
                return stop == null ? new Move(0, 0, false) : stop.result();
            }
            move = current;
        }
        return drive.done(move.plan());
    }

    /**
     * Ends the move in progress, if there is one; returns when it is over.
     *
     * @param halted whether the motors have been told already
     */
    void end(boolean halted) {
        WatchedMove move = present();
        boolean told = halted;
        if (move != null && !move.isBegunHere() && !move.isUnderWay()) {
            await(() -> move.isUnderWay() || move.isOver());
            told = false;
        }
        if (move != null && !told && drive.isMoving()) {
            drive.halt();
        }
        settle(false);
    }

    /**
     * Begins a move, when the one before is over.
     *
     * @param release whether that one is to end at once, the robot moving or not
     */
    WatchedMove begin(Move plan, boolean release) {
        while (true) {
            settle(release);
            synchronized (this) {
                if (current == null && (stop == null || isWatcher())) {
                    current = new WatchedMove(this, plan, listeners.iterator());
                    return current;
                }
            }
        }
    }

    /** Tells the listeners that a move has started. One of them may end it at once: see {@link WatchedMove#isOver}. */
    void announce(WatchedMove move) {
        move.tellStart(pilot);
    }

    /** From now on, rest of the motors means that the move is over. */
    void follow(WatchedMove move) {
        move.setUnderWay();
        synchronized (this) {
            if (watcher == null) {
                startWatcher();
            }
        }
    }

    /** The same for the move in progress, if there is one. */
    void followPresent() {
        WatchedMove move = present();
        if (move != null) {
            follow(move);
        }
    }

    /** The move in progress, if there is one, is to end even if the robot moves. */
    void releasePresent() {
        WatchedMove move = present();
        if (move != null) {
            move.release();
        }
    }

    /** Waits until a move is over. */
    void await(WatchedMove move) {
        if (!isWatcher()) {
            await(move::isOver);
        } else if (!move.isOver()) {
            finish(move);
        }
    }

    private void settle(boolean release) {
        WatchedMove move = unsettled();
        if (move == null) {
            return;
        }
        if (move.isBegunHere()) {
            move.tellStart(pilot);
            follow(move);
        }
        if (release) {
            move.release();
        }
        await(move);
    }

    /** The move to wait for. A listener of its stop does not wait for that to end, but lets the others hear first. */
    private WatchedMove unsettled() {
        Stop told;
        synchronized (this) {
            if (current != null || stop == null) {
                return current;
            }
            if (!isWatcher()) {
                return stop.move();
            }
            told = stop;
        }
        told.tell(pilot);
        return null;
    }

    private synchronized boolean isWatcher() {
        return Thread.currentThread() == watcher;
    }

    private synchronized void startWatcher() {
        watcher = new Thread(this::watch, "pilot monitor");
        watcher.setDaemon(true);
        watcher.start();
    }

    private void watch() {
        try {
            while (true) {
                await(() -> current != null && current.isUnderWay());
                finish(present());
            }
        } catch (RuntimeException | Error e) {
            // A listener failed: this thread ends as usual, another one sees the next moves through.
            startWatcher();
            throw e;
        }
    }

    private synchronized WatchedMove present() {
        return current;
    }

    private void finish(WatchedMove move) {
        awaitRest(move);
        Move result = drive.done(move.plan());
        result.setValues(result.getMoveType(), result.getDistanceTraveled(), result.getAngleTurned(), false);
        Stop outer;
        Stop mine = new Stop(move, result, listeners.iterator());
        synchronized (this) {
            outer = stop;
            stop = mine;
            current = null;
        }
        try {
            mine.tell(pilot);
        } finally {
            synchronized (this) {
                stop = outer;
                move.setOver();
            }
        }
    }

    private void awaitRest(WatchedMove move) {
        boolean halted = false;
        while (!move.isReleased() && drive.isMoving()) {
            if (!halted && drive.isStalled()) {
                halted = true;
                drive.halt();
            }
            Delay.msDelay(PAUSE_MILLIS);
        }
    }

    /** Waits without giving in to interrupts, which belong to the program. */
    private synchronized void await(BooleanSupplier condition) {
        boolean interrupted = false;
        while (!condition.getAsBoolean()) {
            try {
                wait();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
