package lejos.robotics;

/** Something that can be calibrated while the robot does what calibration needs, such as turning once around. */
public interface Calibrate {
    /** Begins calibration. */
    void startCalibration();

    /** Ends calibration and uses the result. */
    void stopCalibration();
}
