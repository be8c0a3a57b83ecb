package lejos.robotics.filter;

import java.util.Arrays;
import lejos.robotics.SampleProvider;

/**
 * The median of the last samples, for each element; of an even number of samples the lower of the two in the middle.
 */
public class MedianFilter extends SampleBuffer {
    /**
     * A filter over the last samples.
     *
     * @param source where samples come from
     * @param bufferSize how many samples to compare
     * @throws IllegalArgumentException if that is less than 1
     */
    public MedianFilter(SampleProvider source, int bufferSize) {
        super(source, bufferSize);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            float[] values = valuesOf(i);
            Arrays.sort(values);
            sample[offset + i] = values[(values.length - 1) / 2];
        }
    }
}
