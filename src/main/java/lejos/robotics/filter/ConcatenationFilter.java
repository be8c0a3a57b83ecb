package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** Two samples as one. */
public class ConcatenationFilter implements SampleProvider {
    private final SampleProvider first;
    private final SampleProvider second;

    /** The sample of one source followed by that of another. */
    public ConcatenationFilter(SampleProvider source1, SampleProvider source2) {
        this.first = source1;
        this.second = source2;
    }

    @Override
    public int sampleSize() {
        return first.sampleSize() + second.sampleSize();
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        first.fetchSample(sample, offset);
        second.fetchSample(sample, offset + first.sampleSize());
    }
}
