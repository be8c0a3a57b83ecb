package lejos.robotics;

import lejos.utility.Delay;

/** Scans with a range finder on a head that a motor turns. Distances are in centimetres. */
public class RotatingRangeScanner implements RangeScanner {
    private static final int SETTLING_MILLIS = 50;

    /** Greatest distance that is trusted. */
    protected final int MAX_RELIABLE_RANGE_READING = 180;
    /** Distance from the sensor's zero to the axis of the head, added to each reading. */
    protected final int ZERO = 2;
    /** The last readings. */
    protected RangeReadings readings;
    /** The sensor. */
    protected RangeFinder rangeFinder;
    /** The motor. */
    protected RegulatedMotor head;
    /** Where to look, in degrees counter-clockwise from straight ahead. */
    protected float[] angles = {0, 90};
    /** Turns of the motor for one turn of the head. */
    protected int gearRatio;

    /** A scanner without gears; the head's present direction becomes straight ahead. */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder) {
        this(head, rangeFinder, 1);
    }

    /** A scanner; the head's present direction becomes straight ahead. */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder, int gearRatio) {
        this.head = head;
        this.rangeFinder = rangeFinder;
        this.gearRatio = gearRatio;
        head.resetTachoCount();
    }

    /** Sets the turns of the motor for one turn of the head. */
    public void setGearRatio(int gearRatio) {
        this.gearRatio = gearRatio;
    }

    /** Sets the motor. */
    public void setHeadMotor(RegulatedMotor head) {
        this.head = head;
    }

    /** Scans, turns the head back and returns the readings: the same list, with new content, each time. */
    @Override
    public RangeReadings getRangeValues() {
        if (readings == null || readings.size() != angles.length) {
            readings = new RangeReadings(angles.length);
        }
        for (int i = 0; i < angles.length; i++) {
            head.rotateTo((int) angles[i] * gearRatio);
            Delay.msDelay(SETTLING_MILLIS);
            float range = rangeFinder.getRange() + ZERO;
            readings.setRange(i, angles[i], range > MAX_RELIABLE_RANGE_READING ? -1 : range);
        }
        head.rotateTo(0);
        return readings;
    }

    @Override
    public void setAngles(float[] angles) {
        this.angles = angles.clone();
    }

    @Override
    public RangeFinder getRangeFinder() {
        return rangeFinder;
    }
}
