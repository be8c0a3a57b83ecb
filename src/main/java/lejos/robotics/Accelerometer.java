package lejos.robotics;

/** A sensor of acceleration and tilt along three axes, in thousandths of standard gravity. */
public interface Accelerometer {
    /** Acceleration along the x axis. */
    int getXAccel();

    /** Acceleration along the y axis. */
    int getYAccel();

    /** Acceleration along the z axis. */
    int getZAccel();
}
