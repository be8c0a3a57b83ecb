package lejos.robotics.chassis;

import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Move;
import lejos.utility.Matrix;

/**
 * The driven wheels of a robot, moved together.
 *
 * <p>Distances are in the unit of the wheels, speeds in units or degrees per second, accelerations in units or degrees
 * per second squared. No method but {@link #waitComplete} blocks.
 */
public interface Chassis {
    /** Speed of later moves in units per second. */
    double getLinearSpeed();

    /** Sets the speed of later moves in units per second. */
    void setLinearSpeed(double linearSpeed);

    /** Speed of later turns in degrees per second. */
    double getAngularSpeed();

    /** Sets the speed of later turns in degrees per second. */
    void setAngularSpeed(double angularSpeed);

    /** Acceleration of later moves in units per second squared. */
    double getLinearAcceleration();

    /** Sets the acceleration of later moves in units per second squared. */
    void setLinearAcceleration(double linearAcceleration);

    /** Acceleration of later turns in degrees per second squared. */
    double getAngularAcceleration();

    /** Sets the acceleration of later turns in degrees per second squared. */
    void setAngularAcceleration(double angularAcceleration);

    /** One column with what the robot does now: speed (0 or more), its direction in degrees, degrees per second. */
    Matrix getCurrentSpeed();

    /** Whether a wheel moves. */
    boolean isMoving();

    /** Begins to slow down to rest. */
    void stop();

    /** Begins to drive with a speed and to turn with another, until told otherwise. */
    void setVelocity(double linearSpeed, double angularSpeed);

    /** Begins to drive in a direction in degrees from straight ahead and to turn, until told otherwise. */
    void setVelocity(double linearSpeed, double direction, double angularSpeed);

    /** Begins to drive forward and to the left with two speeds and to turn with a third, until told otherwise. */
    void travelCartesian(double xSpeed, double ySpeed, double angularSpeed);

    /** Begins to drive a distance; backward if negative, without end if infinite. */
    void travel(double distance);

    /**
     * Begins to drive along an arc.
     *
     * @param radius distance to the centre, which is to the left if positive; 0 turns on the spot
     * @param angle degrees of the arc; forward if positive, backward if negative, whatever the sign of the radius;
     *     without end if infinite
     */
    void arc(double radius, double angle);

    /** Highest speed the motors can keep up now, in units per second. */
    double getMaxLinearSpeed();

    /** Highest speed of turning the motors can keep up now, in degrees per second. */
    double getMaxAngularSpeed();

    /** Blocks until the wheels stand still. */
    void waitComplete();

    /** Whether a motor is stalled. */
    boolean isStalled();

    /** Least radius of an arc; 0 if the robot can turn on the spot. */
    double getMinRadius();

    /** Sets both speeds; see {@link #setLinearSpeed} and {@link #setAngularSpeed}. */
    void setSpeed(double linearSpeed, double angularSpeed);

    /** Sets both accelerations; see {@link #setLinearAcceleration} and {@link #setAngularAcceleration}. */
    void setAcceleration(double forwardAcceleration, double angularAcceleration);

    /** What the wheels say about the robot's pose; the same object each time, counting from the first call. */
    PoseProvider getPoseProvider();

    /** Notes that a move begins here. */
    void moveStart();

    /** Makes a move say what was done since {@link #moveStart}, and returns it. */
    Move getDisplacement(Move move);

    /** Begins to turn on the spot, to the left if positive; without end if infinite. */
    void rotate(double angle);

    /** Speed now in units per second, 0 or more. */
    double getLinearVelocity();

    /** Direction of the motion now in degrees from straight ahead. */
    double getLinearDirection();

    /** Speed of turning now in degrees per second. */
    double getAngularVelocity();
}
