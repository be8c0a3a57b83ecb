package lejos.utility;

import lejos.robotics.DirectionFinder;
import lejos.robotics.Gyroscope;

/** Derives a heading from a gyroscope by adding up its turn rate, on a thread that never ends. Angles in degrees. */
public class GyroDirectionFinder implements DirectionFinder {
    private static final int PERIOD_MILLIS = 5;
    private static final int CALIBRATION_MILLIS = 2600;
    private static final float DEAD_BAND_DEGREES_PER_SECOND = 1;
    private static final float MILLIS_PER_SECOND = 1000;

    private final Gyroscope gyroscope;
    private float headingDegrees;
    private float zeroDegrees;
    private float rate;
    private float acceleration;
    private boolean calibrating;

    /** Starts with heading 0, without calibration. */
    public GyroDirectionFinder(Gyroscope gyro) {
        this(gyro, false);
    }

    /**
     * Starts with heading 0.
     *
     * @param calibrate whether to calibrate first, which blocks for 2.6 s while the robot must stand still
     */
    public GyroDirectionFinder(Gyroscope gyro, boolean calibrate) {
        gyroscope = gyro;
        Thread regulator = new Thread(this::integrateForEver, "gyro direction");
        regulator.setDaemon(true);
        regulator.start();
        if (calibrate) {
            startCalibration();
        }
    }

    /** Sets the heading. */
    public synchronized void setDegrees(float heading) {
        headingDegrees = heading;
    }

    /** The heading, not reduced to a circle. */
    public synchronized float getDegrees() {
        return headingDegrees;
    }

    /** The turn rate in degrees per second. */
    public synchronized float getAngularVelocity() {
        return rate;
    }

    /** The change of the turn rate in degrees per second squared. */
    public synchronized float getAngularAcceleration() {
        return acceleration;
    }

    @Override
    public synchronized float getDegreesCartesian() {
        return zeroDegrees - headingDegrees;
    }

    /** Sets the heading so that the cartesian one, seen from its zero, is {@code heading}. */
    public synchronized void setDegreesCartesian(float heading) {
        headingDegrees = zeroDegrees - heading;
    }

    @Override
    public synchronized void resetCartesianZero() {
        zeroDegrees = headingDegrees;
    }

    /** Lets the gyroscope find its offset; blocks for 2.6 s while the robot must stand still. */
    @Override
    public void startCalibration() {
        setCalibrating(true);
        Delay.msDelay(CALIBRATION_MILLIS);
    }

    /** Ends a calibration that has not begun. */
    @Override
    public void stopCalibration() {
        setCalibrating(false);
    }

    private synchronized void setCalibrating(boolean wanted) {
        calibrating = wanted;
    }

    private void integrateForEver() {
        long last = System.currentTimeMillis();
        while (true) {
            Delay.msDelay(PERIOD_MILLIS);
            if (takeCalibration()) {
                gyroscope.recalibrateOffset();
            }
            float reading = gyroscope.getAngularVelocity();
            long now = System.currentTimeMillis();
            integrate(reading, (now - last) / MILLIS_PER_SECOND);
            last = now;
        }
    }

    private synchronized boolean takeCalibration() {
        boolean wanted = calibrating;
        calibrating = false;
        return wanted;
    }

    private synchronized void integrate(float reading, float seconds) {
        float newRate = Math.abs(reading) < DEAD_BAND_DEGREES_PER_SECOND ? 0 : reading;
        headingDegrees += newRate * seconds;
        acceleration = (newRate - rate) / seconds;
        rate = newRate;
    }
}
