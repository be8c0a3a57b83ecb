package lejos.robotics.objectdetection;

import lejos.robotics.RangeReading;
import lejos.robotics.Touch;
import lejos.utility.Delay;

/** Finds objects by running into them with a bumper; tells its listeners once per push. */
public class TouchFeatureDetector extends FeatureDetectorAdapter {
    private static final int DELAY_MILLIS = 50;
    private static final int RELEASE_POLL_MILLIS = 5;
    private static final float FORWARD_DEGREES = 90;

    private final Touch touch;
    private final RangeReading bumper;

    /** A detector with the bumper at the robot's centre. */
    public TouchFeatureDetector(Touch touchSensor) {
        this(touchSensor, 0, 0);
    }

    /**
     * A detector.
     *
     * @param touchSensor the bumper
     * @param xOffset how far the bumper is to the right of the centre
     * @param yOffset how far the bumper is before the centre
     */
    public TouchFeatureDetector(Touch touchSensor, double xOffset, double yOffset) {
        super(DELAY_MILLIS);
        touch = touchSensor;
        float angle = (float) StrictMath.toDegrees(StrictMath.atan2(yOffset, xOffset)) - FORWARD_DEGREES;
        bumper = new RangeReading(angle, (float) Math.sqrt(xOffset * xOffset + yOffset * yOffset));
    }

    /** Where the bumper is, if it is pressed, else null. */
    @Override
    public Feature scan() {
        return touch.isPressed() ? new RangeFeature(bumper) : null;
    }

    /** Tells the listeners and waits until the bumper is released. */
    @Override
    protected void notifyListeners(Feature feature) {
        super.notifyListeners(feature);
        while (touch.isPressed()) {
            Delay.msDelay(RELEASE_POLL_MILLIS);
        }
    }
}
