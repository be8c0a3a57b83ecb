package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** The sum of the last samples, for each element; of fewer samples in the beginning. */
public class SumFilter extends AbstractFilter {
    private final Window window;

    /**
     * A filter over the last samples.
     *
     * @param source where samples come from
     * @param length how many samples to add up
     * @throws IllegalArgumentException if that is less than 1
     */
    public SumFilter(SampleProvider source, int length) {
        super(source);
        window = new Window(source, length);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        window.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            double sum = 0;
            for (float value : window.valuesOf(i)) {
                sum += value;
            }
            sample[offset + i] = (float) sum;
        }
    }

    /** How many samples were added up so far. */
    protected int getActualSize() {
        return window.getActualSize();
    }

    private static final class Window extends SampleBuffer {
        Window(SampleProvider source, int length) {
            super(source, length);
        }
    }
}
