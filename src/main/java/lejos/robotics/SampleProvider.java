package lejos.robotics;

/**
 * A source of samples: a sensor in one of its modes, or a filter in front of one.
 *
 * <p>A sample is a fixed number of values taken at one instant, in SI units, except that
 * angles are in degrees, counter-clockwise positive.
 */
public interface SampleProvider {
    /** Number of values in one sample, at least one for a working sensor; constant for the life of the provider. */
    int sampleSize();

    /**
     * Reads one sample.
     *
     * @param sample receives {@link #sampleSize()} values
     * @param offset index of the first of them
     * @throws ArrayIndexOutOfBoundsException if the sample does not fit
     */
    void fetchSample(float[] sample, int offset);
}
