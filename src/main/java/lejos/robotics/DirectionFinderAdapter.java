package lejos.robotics;

import lejos.robotics.filter.ModulusFilter;

/** A compass mode as a {@link DirectionFinder}. */
public class DirectionFinderAdapter implements DirectionFinder {
    private static final float FULL_TURN = 360;

    private final SampleProvider source;
    private final float[] zero;
    private final SampleProvider relative;

    /**
     * An adapter.
     *
     * @param source headings in degrees, counter-clockwise
     */
    public DirectionFinderAdapter(SampleProvider source) {
        this.source = source;
        this.zero = new float[source.sampleSize()];
        this.relative = new ModulusFilter(source, zero, FULL_TURN);
    }

    @Override
    public float getDegreesCartesian() {
        float[] sample = new float[zero.length];
        relative.fetchSample(sample, 0);
        return sample[0];
    }

    /** Begins calibration if the source is one to calibrate. */
    @Override
    public void startCalibration() {
        if (source instanceof Calibrate sensor) {
            sensor.startCalibration();
        }
    }

    /** Ends calibration if the source is one to calibrate. */
    @Override
    public void stopCalibration() {
        if (source instanceof Calibrate sensor) {
            sensor.stopCalibration();
        }
    }

    @Override
    public void resetCartesianZero() {
        source.fetchSample(zero, 0);
    }
}
