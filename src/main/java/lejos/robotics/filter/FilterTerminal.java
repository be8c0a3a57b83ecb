package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** One element of a sample as a plain number or truth value. */
public class FilterTerminal {
    private final SampleProvider source;
    private final float[] sample;
    private int index;

    /** The first element of the source's samples. */
    public FilterTerminal(SampleProvider source) {
        this.source = source;
        this.sample = new float[source.sampleSize()];
    }

    /**
     * Chooses the element.
     *
     * @throws IllegalArgumentException if the source's samples have no such element
     */
    public void setIndex(int index) {
        if (index < 0 || index >= sample.length) {
            throw new IllegalArgumentException("element " + index + " of a sample of " + sample.length);
        }
        this.index = index;
    }

    /** Takes a sample; whether the element is 0. */
    public boolean isFalse() {
        return fetch() == 0;
    }

    /** Takes a sample; whether the element is not 0. */
    public boolean isTrue() {
        return !isFalse();
    }

    /** Takes a sample and returns the element. */
    public float fetch() {
        source.fetchSample(sample, 0);
        return sample[index];
    }
}
