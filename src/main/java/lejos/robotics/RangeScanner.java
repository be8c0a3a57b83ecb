package lejos.robotics;

/** Looks at several angles in turn and measures the distance at each. */
public interface RangeScanner {
    /** Scans and returns one reading per angle; blocks while the head or the robot turns. */
    RangeReadings getRangeValues();

    /** Sets the angles to look at, in degrees from straight ahead, counter-clockwise positive. */
    void setAngles(float[] angles);

    /** The sensor that measures. */
    RangeFinder getRangeFinder();
}
