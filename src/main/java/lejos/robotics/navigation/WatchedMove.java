package lejos.robotics.navigation;

import java.util.Iterator;

/** A move of a pilot, from the decision to begin it until all listeners know that it is over. */
final class WatchedMove {
    private final Thread starter = Thread.currentThread();
    private final Object lock;
    private final Move plan;
    private final Iterator<MoveListener> startListeners;

    // Guarded by the lock.
    private boolean underWay;
    private boolean released;
    private boolean over;

    /**
     * A move that this thread is about to begin.
     *
     * @param lock guards what changes, and is notified when the move is over
     */
    WatchedMove(Object lock, Move plan, Iterator<MoveListener> listeners) {
        this.lock = lock;
        this.plan = plan;
        this.startListeners = listeners;
    }

    /** What is intended. */
    Move plan() {
        return plan;
    }

    /** Tells the listeners that do not know it yet of the start. */
    void tellStart(MoveProvider provider) {
        while (startListeners.hasNext()) {
            startListeners.next().moveStarted(plan, provider);
        }
    }

    /** Whether this thread is still about to begin the move: a listener told of the start calls the pilot. */
    boolean isBegunHere() {
        synchronized (lock) {
            return !underWay && starter == Thread.currentThread();
        }
    }

    boolean isUnderWay() {
        synchronized (lock) {
            return underWay;
        }
    }

    /** From now on rest of the motors means the end. */
    void setUnderWay() {
        synchronized (lock) {
            underWay = true;
            lock.notifyAll();
        }
    }

    boolean isReleased() {
        synchronized (lock) {
            return released;
        }
    }

    /** The move is to end now, even if the robot moves. */
    void release() {
        synchronized (lock) {
            released = true;
        }
    }

    boolean isOver() {
        synchronized (lock) {
            return over;
        }
    }

    void setOver() {
        synchronized (lock) {
            over = true;
            lock.notifyAll();
        }
    }
}
