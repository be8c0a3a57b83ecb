package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/**
 * Takes a sensor's drifting offset out: what it shows on average becomes a reference value.
 *
 * <p>Samples more than two standard deviations from the mean are taken for motion, not drift, and do not count, once 15
 * counted.
 */
public class OffsetCorrectionFilter extends AbstractFilter {
    private static final int DEFAULT_BUFFER_SIZE = 200;

    private final float[] reference;
    private final int bufferSize;
    private final AcceptedValues[] accepted;

    /** A filter to reference values of 0 over the last 200 samples that count. */
    public OffsetCorrectionFilter(SampleProvider source) {
        this(source, new float[source.sampleSize()]);
    }

    /** A filter over the last 200 samples that count. */
    public OffsetCorrectionFilter(SampleProvider source, float[] reference) {
        this(source, reference, DEFAULT_BUFFER_SIZE);
    }

    /**
     * A filter.
     *
     * @param source where samples come from
     * @param reference what the mean of each element becomes
     * @param bufferSize how many samples to average
     */
    public OffsetCorrectionFilter(SampleProvider source, float[] reference, int bufferSize) {
        super(source);
        this.reference = reference;
        this.bufferSize = bufferSize;
        this.accepted = new AcceptedValues[sampleSize];
        reset();
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            accepted[i].offer(sample[offset + i]);
            sample[offset + i] += reference[i] - (float) accepted[i].mean();
        }
    }

    /** Forgets all samples. */
    public void reset() {
        for (int i = 0; i < sampleSize; i++) {
            accepted[i] = new AcceptedValues(bufferSize);
        }
    }

    /** Mean of each element; not a number before the first sample. */
    public float[] getMean() {
        float[] mean = new float[sampleSize];
        for (int i = 0; i < sampleSize; i++) {
            mean[i] = (float) accepted[i].mean();
        }
        return mean;
    }

    /** Standard deviation of each element; not a number before the second sample. */
    public float[] getStandardDeviation() {
        float[] deviation = new float[sampleSize];
        for (int i = 0; i < sampleSize; i++) {
            deviation[i] = (float) accepted[i].standardDeviation();
        }
        return deviation;
    }
}
