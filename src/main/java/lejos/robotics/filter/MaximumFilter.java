package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** The greatest of the last samples, for each element. */
public class MaximumFilter extends SampleBuffer {
    /**
     * A filter over the last samples.
     *
     * @param source where samples come from
     * @param bufferSize how many samples to compare
     * @throws IllegalArgumentException if that is less than 1
     */
    public MaximumFilter(SampleProvider source, int bufferSize) {
        super(source, bufferSize);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            for (float value : valuesOf(i)) {
                sample[offset + i] = Math.max(sample[offset + i], value);
            }
        }
    }
}
