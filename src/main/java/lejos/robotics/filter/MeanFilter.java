package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** The mean of the last samples, for each element; of fewer samples in the beginning. */
public class MeanFilter extends SumFilter {
    /**
     * A filter over the last samples.
     *
     * @param source where samples come from
     * @param length how many samples to average
     * @throws IllegalArgumentException if that is less than 1
     */
    public MeanFilter(SampleProvider source, int length) {
        super(source, length);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            sample[offset + i] /= getActualSize();
        }
    }
}
