package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.MotorRegulation;
import brickless.hardware.MotorSnapshot;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.hardware.RegulationTuning;
import lejos.hardware.motor.MotorRegulator;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * The default regulator of an open motor port: turns leJOS moves into requests for the brick's controller.
 *
 * <p>Commands are serialised by this object's lock; waiting happens outside it. The zero point of the tacho is kept
 * here, so resetting it does not disturb a running move.
 */
final class EV3MotorRegulator implements MotorRegulator {
    private final EV3MotorPort port;
    private final MoveEvents events = new MoveEvents(this);
    private final SynchronizedMoves group = new SynchronizedMoves(this);
    private volatile int zeroDegrees;
    private volatile int limitAngle;
    /** The last request, in the hardware frame; null before the first. Guarded by this. */
    private MoveRequest last;
    /** What the getters report while moves are only recorded; null otherwise. Written under this lock. */
    private volatile MotorSnapshot frozen;
    /** The move recorded for the end of the synchronised block, or null. Guarded by this. */
    private MoveRequest recorded;

    EV3MotorRegulator(EV3MotorPort port) {
        this.port = port;
    }

    @Override
    public void setControlParamaters(int typ, float moveP, float moveI, float moveD, float holdP, float holdI,
            float holdD, int offset) {
        regulation().configure(new RegulationTuning(moveP, moveI, moveD, holdP, holdI, holdD, offset / 100f));
    }

    @Override
    public void newMove(float speed, int acceleration, int limit, boolean hold, boolean waitComplete) {
        synchronized (this) {
            if (port.index() < 0 && !waitComplete && !events.listening()) {
                return;
            }
            MotorSnapshot now = state();
            noticeEnd(now);
            limitAngle = limit;
            MoveRequest request = new MoveRequest(speed, acceleration, hardwareLimit(limit), hold);
            if (!waitComplete && now.state() != RegulationState.STALL && request.equals(last)) {
                return;
            }
            execute(now, request);
        }
        if (waitComplete) {
            waitComplete();
        }
    }

    private int hardwareLimit(int limit) {
        return limit == NO_LIMIT || limit == -NO_LIMIT ? limit : limit + zeroDegrees;
    }

    private void execute(MotorSnapshot now, MoveRequest request) {
        last = request;
        if (frozen != null) {
            recorded = request;
            return;
        }
        events.requested(now, request);
        regulation().move(request);
    }

    @Override
    public synchronized void adjustSpeed(float newSpeed) {
        MotorSnapshot now = last == null || last.speedDegreesPerSecond() == newSpeed ? null : adjustable();
        if (now == null) {
            return;
        }
        last = new MoveRequest(newSpeed, last.accelerationDegreesPerSecondSquared(), last.limitDegrees(), last.hold());
        if (frozen != null) {
            recorded = last;
        } else if (newSpeed == 0) {
            regulation().move(last);
        } else {
            regulation().adjustSpeed(newSpeed);
        }
    }

    @Override
    public synchronized void adjustAcceleration(int newAcc) {
        if (last == null || last.accelerationDegreesPerSecondSquared() == newAcc || adjustable() == null) {
            return;
        }
        last = new MoveRequest(last.speedDegreesPerSecond(), newAcc, last.limitDegrees(), last.hold());
        if (frozen != null) {
            recorded = last;
        } else {
            regulation().adjustAcceleration(newAcc);
        }
    }

    /** The present state if a move is under way that is neither a stop nor in its final deceleration, else null. */
    private MotorSnapshot adjustable() {
        if (last.speedDegreesPerSecond() == 0) {
            return null;
        }
        MotorSnapshot now = state();
        return now.state().moving() && now.state() != RegulationState.DECEL ? now : null;
    }

    /** Blocks until the motor is not moving; inside a synchronised block it returns at once. */
    @Override
    public void waitComplete() {
        if (frozen != null) {
            return;
        }
        regulation().awaitStandstill();
        synchronized (this) {
            noticeEnd(state());
        }
    }

    @Override
    public int getTachoCount() {
        return state().tachoDegrees() - zeroDegrees;
    }

    @Override
    public void resetTachoCount() {
        zeroDegrees = regulation().snapshot().tachoDegrees();
    }

    @Override
    public boolean isMoving() {
        return state().state().moving();
    }

    @Override
    public boolean isStalled() {
        return state().state() == RegulationState.STALL;
    }

    @Override
    public float getCurrentVelocity() {
        return state().velocityDegreesPerSecond();
    }

    @Override
    public float getPosition() {
        return state().positionDegrees() - zeroDegrees;
    }

    @Override
    public int getLimitAngle() {
        return limitAngle;
    }

    @Override
    public void setStallThreshold(int error, int time) {
        regulation().setStallThreshold(error, time);
    }

    @Override
    public synchronized void addListener(RegulatedMotor motor, RegulatedMotorListener listener) {
        noticeEnd(state());
        events.listen(motor, listener);
    }

    @Override
    public synchronized RegulatedMotorListener removeListener() {
        return events.unlisten();
    }

    @Override
    public void synchronizeWith(MotorRegulator[] rl) {
        group.setPartners(rl);
    }

    @Override
    public void startSynchronization() {
        group.start();
    }

    @Override
    public void endSynchronization(boolean immReturn) {
        group.end(immReturn);
    }

    /** 0 to 3 for A to D, −1 when the port is closed. */
    int index() {
        return port.index();
    }

    /** The port was closed: nothing is reported any more. */
    synchronized void portClosed() {
        events.close();
    }

    /** The state of this instant, whether or not moves are being recorded. */
    MotorSnapshot live() {
        return regulation().snapshot();
    }

    /** Records moves from now on instead of starting them; getters report {@code state}. */
    synchronized void freeze(MotorSnapshot state) {
        frozen = state;
        recorded = null;
    }

    /** Hands over the recorded move and tells the listener that it begins; null if there is none. */
    synchronized MoveRequest takeRecorded() {
        MoveRequest request = recorded;
        recorded = null;
        if (request != null) {
            MotorSnapshot now = live();
            events.noticeEnd(now);
            events.requested(now, request);
        }
        return request;
    }

    /** Ends the recording; a move that another thread recorded since {@link #takeRecorded()} starts now. */
    synchronized void thaw() {
        MoveRequest late = recorded;
        frozen = null;
        recorded = null;
        if (late != null) {
            execute(live(), late);
        }
    }

    /** Called by the watching thread: blocks until the motor stands, whatever is recorded meanwhile. */
    void awaitEnd() {
        if (port.index() >= 0) {
            regulation().awaitStandstill();
        }
    }

    /** Called by the watching thread: reports the end of a move that nobody else noticed. Needs this lock. */
    void watch() {
        if (port.index() >= 0) {
            noticeEnd(state());
        }
    }

    /** The tacho as programs see it. */
    int tacho(MotorSnapshot state) {
        return state.tachoDegrees() - zeroDegrees;
    }

    private void noticeEnd(MotorSnapshot now) {
        if (frozen == null) {
            events.noticeEnd(now);
        }
    }

    private MotorSnapshot state() {
        MotorSnapshot held = frozen;
        return held != null ? held : live();
    }

    private MotorRegulation regulation() {
        return port.socket().regulation();
    }

    /** Starts recorded moves in the same control tick. */
    static void moveTogether(int[] ports, MoveRequest[] requests) {
        BrickAccess.brick().moveTogether(ports, requests);
    }
}
