package lejos.robotics.objectdetection;

import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.localization.PoseProvider;

/**
 * Finds objects nearer than a distance. The unit is that of {@link RangeFinder#getRanges}: metres for a
 * {@link lejos.robotics.RangeFinderAdapter}, although its getRange is in centimetres.
 */
public class RangeFeatureDetector extends FeatureDetectorAdapter {
    private final RangeFinder rangeFinder;
    private final float angle;
    private volatile float maxDistance;
    private volatile PoseProvider poseProvider;

    /** A detector that looks straight ahead; distance in the range finder's unit, delay in milliseconds. */
    public RangeFeatureDetector(RangeFinder rf, float maxDistance, int delay) {
        this(rf, maxDistance, delay, 0);
    }

    /**
     * A detector.
     *
     * @param rf measures distances
     * @param maxDistance objects from here on do not count
     * @param delay time between two looks in milliseconds
     * @param angle direction of the sensor in degrees counter-clockwise from straight ahead
     */
    public RangeFeatureDetector(RangeFinder rf, float maxDistance, int delay, double angle) {
        super(delay);
        this.rangeFinder = rf;
        this.maxDistance = maxDistance;
        this.angle = (float) angle;
    }

    /** Makes features carry the robot's pose. */
    public void setPoseProvider(PoseProvider pp) {
        poseProvider = pp;
    }

    /** Sets the distance from which on objects do not count. */
    public void setMaxDistance(float distance) {
        maxDistance = distance;
    }

    /** The distance from which on objects do not count. */
    public float getMaxDistance() {
        return maxDistance;
    }

    /** Looks once: all distances measured, if the nearest object is near enough, else null. */
    @Override
    public Feature scan() {
        float[] ranges = rangeFinder.getRanges();
        if (ranges.length == 0 || !(ranges[0] > 0 && ranges[0] < maxDistance)) {
            return null;
        }
        RangeReadings readings = new RangeReadings(0);
        for (float range : ranges) {
            readings.add(new RangeReading(angle, range));
        }
        return poseProvider == null ? new RangeFeature(readings) : new RangeFeature(readings, poseProvider.getPose());
    }
}
