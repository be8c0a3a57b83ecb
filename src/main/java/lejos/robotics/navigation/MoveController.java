package lejos.robotics.navigation;

/** A robot that can drive straight ahead. Distances are in the unit of the wheel diameter. */
public interface MoveController extends MoveProvider {
    /** Wheel of the first NXT kit, diameter in centimetres. */
    double WHEEL_SIZE_NXT1 = 5.60;
    /** Wheel of the second NXT kit, diameter in centimetres. */
    double WHEEL_SIZE_NXT2 = 4.32;
    /** Wheel of the EV3 kit, diameter in centimetres. */
    double WHEEL_SIZE_EV3 = WHEEL_SIZE_NXT2;
    /** Wheel of the RCX kit, diameter in centimetres. */
    double WHEEL_SIZE_RCX = 8.16;

    /** Starts driving forward and returns at once. */
    void forward();

    /** Starts driving backward and returns at once. */
    void backward();

    /** Stops; returns at rest. */
    void stop();

    /** Whether the robot moves. */
    boolean isMoving();

    /** Drives a distance and returns when done; backward if negative, without end if infinite. */
    void travel(double distance);

    /**
     * Drives a distance.
     *
     * @param distance backward if negative, without end if infinite
     * @param immediateReturn true to return at once, false to return when done
     */
    void travel(double distance, boolean immediateReturn);

    /** Sets the speed of later moves, in units per second. */
    void setLinearSpeed(double speed);

    /** The speed set, in units per second. */
    double getLinearSpeed();

    /** Highest speed the robot can keep up now, in units per second. */
    double getMaxLinearSpeed();

    /** Sets the acceleration of later moves, in units per second squared. */
    void setLinearAcceleration(double acceleration);

    /** The acceleration set, in units per second squared. */
    double getLinearAcceleration();

    /**
     * The same as {@link #setLinearSpeed}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default void setTravelSpeed(double speed) {
        setLinearSpeed(speed);
    }

    /**
     * The same as {@link #getLinearSpeed}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default double getTravelSpeed() {
        return getLinearSpeed();
    }

    /**
     * The same as {@link #getMaxLinearSpeed}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    default double getMaxTravelSpeed() {
        return getMaxLinearSpeed();
    }
}
