package lejos.robotics;

import lejos.robotics.navigation.RotateMoveController;
import lejos.utility.Delay;

/** Scans with a range finder fixed to a robot that turns on the spot. Distances are in centimetres. */
public class FixedRangeScanner implements RangeScanner {
    private static final int SETTLING_MILLIS = 50;
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    /** The sensor. */
    protected RangeFinder rangeFinder;
    /** Turns the robot. */
    protected RotateMoveController pilot;
    /** Where to look, in degrees counter-clockwise from straight ahead. */
    protected float[] angles;
    /** Greatest distance that is trusted. */
    protected final int MAX_RELIABLE_RANGE_READING = 180;
    /** Distance from the sensor's zero to the robot's centre, added to each reading. */
    protected final int ZERO = 2;
    /** The last readings. */
    protected RangeReadings readings;

    /** A scanner, which needs {@link #setAngles} before it can scan. */
    public FixedRangeScanner(RotateMoveController pilot, RangeFinder rangeFinder) {
        this.pilot = pilot;
        this.rangeFinder = rangeFinder;
    }

    /**
     * Scans, turns the robot back and returns the readings: the same list, with new content, each time.
     *
     * @throws NullPointerException if no angles were set
     */
    @Override
    public RangeReadings getRangeValues() {
        if (readings == null || readings.size() != angles.length) {
            readings = new RangeReadings(angles.length);
        }
        float heading = 0;
        for (int i = 0; i < angles.length; i++) {
            pilot.rotate(normalize(angles[i] - heading), false);
            heading = angles[i];
            Delay.msDelay(SETTLING_MILLIS);
            float range = rangeFinder.getRange() + ZERO;
            readings.setRange(i, angles[i], range > MAX_RELIABLE_RANGE_READING ? -1 : range);
        }
        pilot.rotate(normalize(-heading), false);
        return readings;
    }

    /** Sets the angles to look at, in degrees from straight ahead; not copied. */
    @Override
    public void setAngles(float[] angles) {
        this.angles = angles;
    }

    @Override
    public RangeFinder getRangeFinder() {
        return rangeFinder;
    }

    private static float normalize(float angle) {
        float turn = angle;
        while (turn > HALF_TURN) {
            turn -= FULL_TURN;
        }
        while (turn < -HALF_TURN) {
            turn += FULL_TURN;
        }
        return turn;
    }
}
