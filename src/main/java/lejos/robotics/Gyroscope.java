package lejos.robotics;

/** A sensor of rotation about one axis. */
public interface Gyroscope {
    /** Angular velocity in degrees per second, counter-clockwise positive. */
    float getAngularVelocity();

    /** Measures the offset of the resting sensor anew; blocks meanwhile. */
    void recalibrateOffset();

    /** Angle since the last reset, in degrees, counter-clockwise positive. */
    int getAngle();

    /** Makes the present angle zero. */
    void reset();
}
