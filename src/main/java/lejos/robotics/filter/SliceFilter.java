package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** Part of a sample. */
public class SliceFilter extends AbstractFilter {
    private final int first;
    private final int last;
    private final float[] whole;

    /**
     * A filter.
     *
     * @param source where samples come from
     * @param firstElement index of the first element to keep
     * @param lastElement index of the last element to keep
     */
    public SliceFilter(SampleProvider source, int firstElement, int lastElement) {
        super(source);
        this.first = firstElement;
        this.last = lastElement;
        this.whole = new float[sampleSize];
    }

    @Override
    public int sampleSize() {
        return last - first + 1;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(whole, 0);
        System.arraycopy(whole, first, sample, offset, sampleSize());
    }
}
