package lejos.robotics;

import lejos.robotics.filter.IntegrationFilter;
import lejos.robotics.filter.LinearCalibrationFilter;
import lejos.robotics.filter.SampleThread;
import lejos.utility.Delay;

/** A rate mode as a {@link Gyroscope}: takes samples on a thread of its own and adds them up to an angle. */
public class GyroscopeAdapter implements Gyroscope {
    private static final int CALIBRATION_MILLIS = 1000;

    private final LinearCalibrationFilter calibrated;
    private final IntegrationFilter integral;
    private final SampleThread sampler;

    /**
     * An adapter.
     *
     * @param source angular velocities in degrees per second
     * @param sampleFreq samples per second
     * @param axis which element of a sample to use
     */
    public GyroscopeAdapter(SampleProvider source, float sampleFreq, int axis) {
        calibrated = new LinearCalibrationFilter(new Axis(source, axis));
        integral = new IntegrationFilter(calibrated);
        sampler = new SampleThread(integral, sampleFreq);
    }

    /** An adapter for the first element of a sample. */
    public GyroscopeAdapter(SampleProvider source, float sampleFreq) {
        this(source, sampleFreq, 0);
    }

    @Override
    public float getAngularVelocity() {
        float[] sample = new float[1];
        calibrated.fetchSample(sample, 0);
        return sample[0];
    }

    /** Takes the mean of a second, in which the robot must rest, for the offset; blocks as long. */
    @Override
    public void recalibrateOffset() {
        calibrated.startCalibration();
        Delay.msDelay(CALIBRATION_MILLIS);
        calibrated.stopCalibration();
    }

    @Override
    public int getAngle() {
        float[] sample = new float[1];
        sampler.fetchSample(sample, 0);
        return (int) sample[0];
    }

    @Override
    public void reset() {
        integral.resetTo(0);
    }

    /** One element of a source; may be used by several threads at once, which a slice filter may not. */
    private record Axis(SampleProvider source, int index) implements SampleProvider {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            float[] all = new float[source.sampleSize()];
            source.fetchSample(all, 0);
            sample[offset] = all[index];
        }
    }
}
