package lejos.internal.ev3;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MotorSnapshot;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * Reports the starts and ends of one motor's moves. Blended moves report nothing in between.
 *
 * <p>Every method needs the regulator's lock, and listeners are called under it: by the commanding thread, by a thread
 * that waited for the end of the move, or by a daemon that sleeps through the move and looks at most 5 ms after its
 * end.
 */
final class MoveEvents {
    private static final int LOOK_MILLIS = 5;

    private final EV3MotorRegulator regulator;
    private RegulatedMotor motor;
    private RegulatedMotorListener listener;
    private boolean underWay;
    private boolean closed;
    private Thread watcher;

    MoveEvents(EV3MotorRegulator regulator) {
        this.regulator = regulator;
    }

    boolean listening() {
        return listener != null;
    }

    void listen(RegulatedMotor source, RegulatedMotorListener newListener) {
        motor = source;
        listener = newListener;
        if (watcher == null && listener != null) {
            watcher = new Thread(this::watch, "motor listener " + source.getClass().getSimpleName());
            watcher.setDaemon(true);
            watcher.start();
        }
        regulator.notifyAll();
    }

    RegulatedMotorListener unlisten() {
        RegulatedMotorListener removed = listener;
        listener = null;
        return removed;
    }

    void close() {
        closed = true;
        listener = null;
        regulator.notifyAll();
    }

    /** A move is about to be sent to a motor in state {@code now}. */
    void requested(MotorSnapshot now, MoveRequest request) {
        if (now.state().moving() || !moves(now, request)) {
            return;
        }
        if (listener != null) {
            listener.rotationStarted(motor, regulator.tacho(now), false, System.currentTimeMillis());
        }
        underWay = true;
        regulator.notifyAll();
    }

    private static boolean moves(MotorSnapshot now, MoveRequest request) {
        boolean endless = Math.abs(request.limitDegrees()) == MotorRegulation.NO_LIMIT;
        return request.speedDegreesPerSecond() != 0 && (endless || request.limitDegrees() != now.positionDegrees());
    }

    /** Looks whether the move under way has ended. */
    void noticeEnd(MotorSnapshot now) {
        if (!underWay || now.state().moving()) {
            return;
        }
        underWay = false;
        if (listener != null) {
            boolean stalled = now.state() == RegulationState.STALL;
            listener.rotationStopped(motor, regulator.tacho(now), stalled, System.currentTimeMillis());
        }
    }

    private void watch() {
        try {
            while (awaitMove()) {
                regulator.awaitEnd();
                reportEnd();
            }
        } catch (InterruptedException e) {
            // Nobody but a program that collects all threads interrupts this one; it wants it gone.
            Thread.currentThread().interrupt();
        }
    }

    /** Sleeps until there is a move to watch; false when the port has been closed. */
    private boolean awaitMove() throws InterruptedException {
        synchronized (regulator) {
            while (!closed && (!underWay || listener == null)) {
                regulator.wait();
            }
            return !closed;
        }
    }

    /** Gives a thread that waited for the same end the time to notice it first, as the original's next look does. */
    private void reportEnd() throws InterruptedException {
        synchronized (regulator) {
            regulator.wait(LOOK_MILLIS);
            if (!closed) {
                regulator.watch();
            }
        }
    }
}
