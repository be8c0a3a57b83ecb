package lejos.robotics;

import java.io.Closeable;

/**
 * A motor that keeps to speeds and angles: it accelerates, cruises and decelerates as planned and holds its position.
 *
 * <p>Angles are in degrees, speeds in degrees per second, accelerations in degrees per second squared. A new command
 * replaces the one in progress, beginning at the present speed.
 */
public interface RegulatedMotor extends BaseMotor, Tachometer, Closeable {
    /** Registers the one listener of this motor, in place of the earlier one. */
    void addListener(RegulatedMotorListener listener);

    /** Takes the listener away and returns it; {@code null} if there was none. */
    RegulatedMotorListener removeListener();

    /**
     * Decelerates to rest and holds the position.
     *
     * @param immediateReturn true to return at once, false to return at rest
     */
    void stop(boolean immediateReturn);

    /**
     * Decelerates to rest and then lets the motor turn freely.
     *
     * @param immediateReturn true to return at once, false to return at rest
     */
    void flt(boolean immediateReturn);

    /** Blocks until the motion is complete. */
    void waitComplete();

    /**
     * Turns by an angle.
     *
     * @param angle degrees, positive forward
     * @param immediateReturn true to return at once, false to return when done
     */
    void rotate(int angle, boolean immediateReturn);

    /** Turns by an angle in degrees and returns when done. */
    void rotate(int angle);

    /** Turns to an angle in degrees and returns when done. */
    void rotateTo(int limitAngle);

    /**
     * Turns to an angle.
     *
     * @param limitAngle target as {@link #getTachoCount()} will report it, in degrees; any number of turns
     * @param immediateReturn true to return at once, false to return when done
     */
    void rotateTo(int limitAngle, boolean immediateReturn);

    /** Target of the present or last motion in degrees. */
    int getLimitAngle();

    /** Sets the speed in degrees per second; the sign is dropped. A running motion takes it over. */
    void setSpeed(int speed);

    /** The speed last set, in degrees per second. */
    int getSpeed();

    /** Highest speed that the battery now allows for a reasonable load, in degrees per second. */
    float getMaxSpeed();

    /** True if the last motion ended because the motor could not follow. */
    boolean isStalled();

    /**
     * Says when a motor that falls behind counts as stalled.
     *
     * @param error lag in degrees
     * @param time for how long, in milliseconds
     */
    void setStallThreshold(int error, int time);

    /** Sets the acceleration for speeding up and slowing down, in degrees per second squared; the sign is dropped. */
    void setAcceleration(int acceleration);

    /**
     * Makes this motor the master of others, whose commands can then be held back and started together.
     *
     * @param syncList the other motors; this one must not be among them
     */
    void synchronizeWith(RegulatedMotor[] syncList);

    /** Holds back commands to this motor and to those synchronised with it until {@link #endSynchronization()}. */
    void startSynchronization();

    /** Starts all commands held back, in the same instant. */
    void endSynchronization();

    /** Stops the motor and gives its port back. */
    @Override
    void close();
}
