package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** Counts values from a zero of its own for each element. */
public class ZeroFilter extends AbstractFilter {
    private final float[] zero;

    /**
     * A filter.
     *
     * @param source where samples come from
     * @param zeroValue the value of each element that becomes 0; not copied
     */
    public ZeroFilter(SampleProvider source, float[] zeroValue) {
        super(source);
        this.zero = zeroValue;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            sample[offset + i] -= zero[i];
        }
    }
}
