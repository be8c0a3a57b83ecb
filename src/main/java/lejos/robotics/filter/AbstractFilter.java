package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** A filter that changes nothing; the base of those that do. */
public abstract class AbstractFilter implements SampleProvider {
    /** Where samples come from. */
    protected final SampleProvider source;

    /** Number of values in a sample of the source. */
    protected int sampleSize;

    /**
     * A filter.
     *
     * @param source where samples come from
     */
    public AbstractFilter(SampleProvider source) {
        this.source = source;
        this.sampleSize = source.sampleSize();
    }

    @Override
    public int sampleSize() {
        return sampleSize;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        source.fetchSample(sample, offset);
    }
}
