package lejos.robotics.navigation;

/** A robot that can turn on the spot. Angles are in degrees, to the left positive. */
public interface RotateMoveController extends MoveController {
    /** Turns by an angle and returns when done. */
    void rotate(double angle);

    /**
     * Turns by an angle.
     *
     * @param angle degrees, to the left positive; without end if infinite
     * @param immediateReturn true to return at once, false to return when done
     */
    void rotate(double angle, boolean immediateReturn);

    /** Sets the speed of later turns, in degrees per second. */
    void setAngularSpeed(double speed);

    /** The speed of turns, in degrees per second. */
    double getAngularSpeed();

    /** Highest speed of turns the robot can keep up now, in degrees per second. */
    double getMaxAngularSpeed();

    /** Sets the acceleration of later turns, in degrees per second squared. */
    void setAngularAcceleration(double acceleration);

    /** The acceleration of turns, in degrees per second squared. */
    double getAngularAcceleration();

    /** Starts turning to the right and returns at once. */
    void rotateRight();

    /** Starts turning to the left and returns at once. */
    void rotateLeft();

    /**
     * The same as {@link #setAngularSpeed}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default void setRotateSpeed(double speed) {
        setAngularSpeed(speed);
    }

    /**
     * The same as {@link #getAngularSpeed}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default double getRotateSpeed() {
        return getAngularSpeed();
    }

    /**
     * The same as {@link #getMaxAngularSpeed}, by a name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default float getMaxRotateSpeed() {
        return (float) getMaxAngularSpeed();
    }

    /**
     * The same as {@link #getMaxAngularSpeed}, by a name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default double getRotateMaxSpeed() {
        return getMaxAngularSpeed();
    }
}
