package lejos.robotics;

import lejos.utility.Delay;

/** Looks around for beacons of light with a light detector on a motor. */
public class LightScanner {
    private static final int DEFAULT_SPEED = 100;
    private static final int RETURN_SPEED = 700;
    private static final int SAMPLE_MILLIS = 2;

    /** Turns the detector. */
    protected RegulatedMotor head;

    private final LightDetector detector;
    private final int minBeaconLight;
    private final int background;
    private int speed = DEFAULT_SPEED;

    /**
     * A scanner.
     *
     * @param head turns the detector; positive to the left
     * @param detector measures brightness
     * @param minBeaconLight least brightness of a beacon
     * @param background brightness below which a beacon has been passed
     */
    public LightScanner(RegulatedMotor head, LightDetector detector, int minBeaconLight, int background) {
        this.head = head;
        this.detector = detector;
        this.minBeaconLight = minBeaconLight;
        this.background = background;
        head.setSpeed(DEFAULT_SPEED);
    }

    /** Sets the speed of the scan in degrees per second. */
    public void setSpeed(int speed) {
        this.speed = speed;
        head.setSpeed(speed);
    }

    /** Stops the scan. */
    public void halt() {
        head.stop();
    }

    /**
     * Turns from one angle to another, and then back to straight ahead without waiting for that.
     *
     * @param startAngle where to begin, in degrees
     * @param endAngle where to end, in degrees
     * @param minWidth least angle in degrees that a beacon extends over
     * @param maxBeacons number of beacons after which the scan ends
     * @return direction and brightness of each beacon at its brightest
     */
    public RangeReadings scanLight(float startAngle, float endAngle, int minWidth, int maxBeacons) {
        head.setSpeed(RETURN_SPEED);
        head.rotateTo((int) startAngle);
        head.setSpeed(speed);
        head.rotateTo((int) endAngle, true);
        RangeReadings beacons = new RangeReadings(0);
        while (head.isMoving() && beacons.size() < maxBeacons) {
            if (detector.getLightValue() >= minBeaconLight) {
                addBeacon(beacons, minWidth);
            }
            Delay.msDelay(SAMPLE_MILLIS);
        }
        head.setSpeed(RETURN_SPEED);
        head.rotateTo(0, true);
        return beacons;
    }

    private void addBeacon(RangeReadings beacons, int minWidth) {
        int begin = head.getTachoCount();
        float brightest = 0;
        int direction = begin;
        float light = detector.getLightValue();
        while (head.isMoving() && light >= background) {
            if (light > brightest) {
                brightest = light;
                direction = head.getTachoCount();
            }
            Delay.msDelay(SAMPLE_MILLIS);
            light = detector.getLightValue();
        }
        if (Math.abs(head.getTachoCount() - begin) >= minWidth) {
            beacons.add(new RangeReading(direction, brightest));
        }
    }

    /** The motor that turns the detector. */
    public RegulatedMotor getMotor() {
        return head;
    }
}
