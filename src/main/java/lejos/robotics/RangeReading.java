package lejos.robotics;

/** A distance measured at an angle. Immutable. */
public class RangeReading {
    private final float angle;
    private final float range;

    /**
     * A reading.
     *
     * @param angle degrees from straight ahead, counter-clockwise positive
     * @param range distance in the range finder's unit; negative if nothing was measured
     */
    public RangeReading(float angle, float range) {
        this.angle = angle;
        this.range = range;
    }

    /** Distance; negative if nothing was measured. */
    public float getRange() {
        return range;
    }

    /** Angle in degrees from straight ahead, counter-clockwise positive. */
    public float getAngle() {
        return angle;
    }

    /** Whether nothing was measured. */
    public boolean invalidReading() {
        return range < 0;
    }
}
