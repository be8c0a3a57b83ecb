package lejos.hardware.motor;

import brickless.hardware.BrickAccess;
import lejos.hardware.Device;
import lejos.hardware.port.Port;
import lejos.hardware.port.TachoMotorPort;
import lejos.internal.ev3.EV3Ports;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * A motor with an encoder whose speed and angle are regulated.
 *
 * <p>Speeds are degrees per second, accelerations degrees per second squared, angles degrees, forward positive. A new
 * move replaces the running one in a continuous ramp. Threads may share a motor: commands are serialised, waiting does
 * not hold others up.
 */
public abstract class BaseRegulatedMotor extends Device implements RegulatedMotor {
    /** Limit of a move without end. */
    protected static final int NO_LIMIT = MotorRegulator.NO_LIMIT;

    private static final int DEFAULT_SPEED = 360;
    private static final int DEFAULT_ACCELERATION = 6000;
    /** Share of the free speed that a loaded motor can be expected to reach. */
    private static final double USABLE_SHARE = 0.9;

    /** Speed of the free motor at 9 V, degrees per second. */
    protected final int MAX_SPEED_AT_9V;
    /** What moves the motor. */
    protected final MotorRegulator reg;
    /** The port the motor is plugged into. */
    protected TachoMotorPort tachoPort;
    /** Speed of the next move, 0 or more. */
    protected float speed = DEFAULT_SPEED;
    /** Acceleration of the next move. */
    protected int acceleration = DEFAULT_ACCELERATION;

    private boolean closed;

    /**
     * A motor on an open port, which {@link #close()} leaves open.
     *
     * @param port the open port
     * @param regulator what moves the motor; null for the port's own regulator
     * @param typ LEGO type number
     * @param moveP proportional gain while moving
     * @param moveI integral gain while moving
     * @param moveD differential gain while moving
     * @param holdP proportional gain while holding
     * @param holdI integral gain while holding
     * @param holdD differential gain while holding
     * @param offset power added against friction, 0 to 10000
     * @param maxSpeed speed of the free motor at 9 V, degrees per second
     */
    public BaseRegulatedMotor(TachoMotorPort port, MotorRegulator regulator, int typ, float moveP, float moveI,
            float moveD, float holdP, float holdI, float holdD, int offset, int maxSpeed) {
        EV3Ports.announce(port, this);
        tachoPort = port;
        reg = regulator == null ? port.getRegulator() : regulator;
        MAX_SPEED_AT_9V = maxSpeed;
        reg.setControlParamaters(typ, moveP, moveI, moveD, holdP, holdI, holdD, offset);
    }

    /**
     * A motor on a port that is opened now and closed with the motor; parameters as above.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a motor port
     */
    public BaseRegulatedMotor(Port port, MotorRegulator regulator, int typ, float moveP, float moveI, float moveD,
            float holdP, float holdI, float holdD, int offset, int maxSpeed) {
        this(port.open(TachoMotorPort.class), regulator, typ, moveP, moveI, moveD, holdP, holdI, holdD, offset,
                maxSpeed);
        releaseOnClose(tachoPort);
    }

    /**
     * Stops the motor, blocking until it stands, lets it float, and closes the port if this object opened it. May be
     * called again.
     */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        suspendRegulation();
        super.close();
    }

    /** Stops and lets the motor float, blocking until it stands; any later move regulates again. Returns true. */
    public boolean suspendRegulation() {
        reg.newMove(0, acceleration, NO_LIMIT, false, true);
        return true;
    }

    @Override
    public int getTachoCount() {
        return reg.getTachoCount();
    }

    /**
     * Position of the regulator's model in degrees: stays at the target while the wheel is held, even if the encoder
     * deviates.
     */
    public float getPosition() {
        return reg.getPosition();
    }

    @Override
    public void forward() {
        reg.newMove(speed, acceleration, +NO_LIMIT, true, false);
    }

    @Override
    public void backward() {
        reg.newMove(speed, acceleration, -NO_LIMIT, true, false);
    }

    /** Slows down under regulation, then lets the motor float; blocks until it stands. */
    @Override
    public void flt() {
        flt(false);
    }

    /**
     * Slows down under regulation, then lets the motor float; blocks until it stands unless {@code immediateReturn}.
     */
    @Override
    public void flt(boolean immediateReturn) {
        reg.newMove(0, acceleration, NO_LIMIT, false, !immediateReturn);
    }

    /** Slows down under regulation, then holds the position; blocks until the motor stands. */
    @Override
    public void stop() {
        stop(false);
    }

    /**
     * Slows down under regulation, then holds the position; blocks until the motor stands unless {@code
     * immediateReturn}.
     */
    @Override
    public void stop(boolean immediateReturn) {
        reg.newMove(0, acceleration, NO_LIMIT, true, !immediateReturn);
    }

    /** Whether a move is under way; false as soon as it is complete or given up as stalled. */
    @Override
    public boolean isMoving() {
        return reg.isMoving();
    }

    @Override
    public void waitComplete() {
        reg.waitComplete();
    }

    @Override
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        reg.newMove(speed, acceleration, limitAngle, true, !immediateReturn);
    }

    /** Sets the speed of this and later moves; the sign is dropped, no upper limit applies. */
    @Override
    public void setSpeed(int speed) {
        setSpeed((float) speed);
    }

    /** Sets the speed of this and later moves; the sign is dropped, no upper limit applies. */
    public void setSpeed(float speed) {
        this.speed = Math.abs(speed);
        reg.adjustSpeed(this.speed);
    }

    @Override
    public void setAcceleration(int acceleration) {
        this.acceleration = Math.abs(acceleration);
        reg.adjustAcceleration(this.acceleration);
    }

    /** The acceleration set last. */
    public int getAcceleration() {
        return acceleration;
    }

    /** Limit of the last move: its target, or ±{@link #NO_LIMIT} for moves without end and for stops. */
    @Override
    public int getLimitAngle() {
        return reg.getLimitAngle();
    }

    /** Makes the present angle zero without disturbing a running move. */
    @Override
    public void resetTachoCount() {
        reg.resetTachoCount();
    }

    /** Reports starts and ends of moves to {@code listener}, in place of an earlier one. */
    @Override
    public void addListener(RegulatedMotorListener listener) {
        reg.addListener(this, listener);
    }

    @Override
    public RegulatedMotorListener removeListener() {
        return reg.removeListener();
    }

    /** Turns by {@code angle} degrees from the model's position, so that repeated calls do not add up errors. */
    @Override
    public void rotate(int angle, boolean immediateReturn) {
        rotateTo(Math.round(reg.getPosition()) + angle, immediateReturn);
    }

    @Override
    public void rotate(int angle) {
        rotate(angle, false);
    }

    @Override
    public void rotateTo(int limitAngle) {
        rotateTo(limitAngle, false);
    }

    @Override
    public int getSpeed() {
        return Math.round(speed);
    }

    /**
     * Stops and holds; blocks until the motor stands.
     *
     * @param power ignored
     * @deprecated use {@link #stop()}
     */
    @Deprecated
    public void lock(int power) {
        stop(false);
    }

    @Override
    public boolean isStalled() {
        return reg.isStalled();
    }

    @Override
    public void setStallThreshold(int error, int time) {
        reg.setStallThreshold(error, time);
    }

    /** Velocity of the regulator's model, not of the wheel. */
    @Override
    public int getRotationSpeed() {
        return Math.round(reg.getCurrentVelocity());
    }

    /** Speed that the motor can be expected to reach at the present battery voltage, degrees per second. */
    @Override
    public float getMaxSpeed() {
        float volts = BrickAccess.brick().power().voltageVolts();
        return (float) (volts * MAX_SPEED_AT_9V / 9.0 * USABLE_SHARE);
    }

    /**
     * Sets the partners for synchronised moves, in place of earlier ones.
     *
     * @throws ClassCastException if one of them is not a {@link BaseRegulatedMotor}
     * @throws IllegalArgumentException if this motor is among them
     */
    @Override
    public void synchronizeWith(RegulatedMotor[] syncList) {
        MotorRegulator[] partners = new MotorRegulator[syncList.length];
        for (int i = 0; i < syncList.length; i++) {
            partners[i] = ((BaseRegulatedMotor) syncList[i]).reg;
        }
        reg.synchronizeWith(partners);
    }

    /** From now on moves of this motor and its partners are recorded only, the last one of each motor counting. */
    @Override
    public void startSynchronization() {
        reg.startSynchronization();
    }

    /** Starts all recorded moves together and returns at once. */
    @Override
    public void endSynchronization() {
        reg.endSynchronization(true);
    }
}
