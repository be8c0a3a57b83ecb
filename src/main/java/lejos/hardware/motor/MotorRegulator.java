package lejos.hardware.motor;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * What moves a motor in a controlled way. Angles are degrees in the frame set by {@link #resetTachoCount()}, forward
 * positive.
 */
public interface MotorRegulator {
    /** Limit of a move without end; negative for backward. */
    int NO_LIMIT = 0x7fffffff;

    /**
     * Sets the constants of the tracking loop.
     *
     * @param typ LEGO type number of the motor
     * @param moveP proportional gain while moving, percent of full power per degree
     * @param moveI integral gain while moving
     * @param moveD differential gain while moving
     * @param holdP proportional gain while holding
     * @param holdI integral gain while holding
     * @param holdD differential gain while holding
     * @param offset power added against friction, 0 to 10000 for 0 to 100 %
     */
    void setControlParamaters(int typ, float moveP, float moveI, float moveD, float holdP, float holdI, float holdD,
            int offset);

    /** Encoder count in whole degrees. */
    int getTachoCount();

    /** Makes the present encoder count zero. */
    void resetTachoCount();

    /** Whether a move is under way; false once it is complete, stalled or held. */
    boolean isMoving();

    /** Velocity of the controller's model, degrees per second, forward positive. */
    float getCurrentVelocity();

    /**
     * Sets when a move is given up.
     *
     * @param error lag in degrees that counts as blocked
     * @param time how long it must last, milliseconds
     */
    void setStallThreshold(int error, int time);

    /** Position of the controller's model, degrees. */
    float getPosition();

    /**
     * Starts a move, replacing the running one.
     *
     * @param speed degrees per second, 0 to stop
     * @param acceleration degrees per second squared, above 0
     * @param limit target angle, or ±{@link #NO_LIMIT}
     * @param hold whether to hold the position afterwards; otherwise the motor floats
     * @param waitComplete whether to block until the motor is not moving
     */
    void newMove(float speed, int acceleration, int limit, boolean hold, boolean waitComplete);

    /** Changes the speed of the running move, degrees per second. */
    void adjustSpeed(float newSpeed);

    /** Changes the acceleration of the running move, degrees per second squared. */
    void adjustAcceleration(int newAcc);

    /** Blocks until the motor is not moving. Interrupts are ignored and kept. */
    void waitComplete();

    /** Reports the starts and ends of moves of {@code motor} to {@code listener}, in place of an earlier one. */
    void addListener(RegulatedMotor motor, RegulatedMotorListener listener);

    /** Removes the listener; returns it, or null if there was none. */
    RegulatedMotorListener removeListener();

    /** Limit of the last move requested. */
    int getLimitAngle();

    /** Whether the last move was given up because the motor was blocked. */
    boolean isStalled();

    /** Begins to record moves of this motor and its partners instead of starting them. */
    void startSynchronization();

    /**
     * Starts all recorded moves together.
     *
     * @param immReturn false to block until all of them are complete
     */
    void endSynchronization(boolean immReturn);

    /** Sets the partners of this motor in synchronised moves, in place of earlier ones. */
    void synchronizeWith(MotorRegulator[] rl);
}
