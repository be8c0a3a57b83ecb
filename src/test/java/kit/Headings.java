package kit;

import lejos.robotics.Gyroscope;
import lejos.utility.Delay;
import lejos.utility.GyroDirectionFinder;

/** A heading from a gyroscope that turns as it is told. */
public final class Headings implements Gyroscope {
    private volatile float rate = 90;
    private volatile int calibrations;

    private Headings() {}

    public static void main(String[] args) {
        Headings gyro = new Headings();
        GyroDirectionFinder finder = new GyroDirectionFinder(gyro);
        Delay.msDelay(1000);
        System.out.println("degrees " + finder.getDegrees());
        System.out.println("velocity " + finder.getAngularVelocity());
        System.out.println("acceleration " + finder.getAngularAcceleration());
        finder.resetCartesianZero();
        Delay.msDelay(500);
        System.out.println("cartesian " + finder.getDegreesCartesian());
        gyro.rate = 0.9f;
        Delay.msDelay(20);
        float still = finder.getDegrees();
        Delay.msDelay(1000);
        System.out.println("deadBand " + (finder.getDegrees() - still));
        finder.setDegrees(700);
        System.out.println("unbounded " + finder.getDegrees());
        finder.setDegreesCartesian(30);
        System.out.println("set " + finder.getDegreesCartesian());
        long begin = System.currentTimeMillis();
        finder.startCalibration();
        System.out.println("calibration " + (System.currentTimeMillis() - begin) + " " + gyro.calibrations);
        new GyroDirectionFinder(gyro, true).stopCalibration();
        System.out.println("calibrations " + gyro.calibrations);
    }

    @Override
    public float getAngularVelocity() {
        return rate;
    }

    @Override
    public void recalibrateOffset() {
        calibrations++;
    }

    @Override
    public int getAngle() {
        throw new UnsupportedOperationException("the finder adds up the rate itself");
    }

    @Override
    public void reset() {
        throw new UnsupportedOperationException("the finder has a zero of its own");
    }
}
