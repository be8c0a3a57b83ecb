package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** Passes samples on and remembers the last of them. */
public abstract class SampleBuffer extends AbstractFilter {
    private final float[][] ring;
    private int next;
    private int actualSize;

    /**
     * A buffer.
     *
     * @param source where samples come from
     * @param bufferSize how many samples to remember
     * @throws IllegalArgumentException if that is less than 1
     */
    public SampleBuffer(SampleProvider source, int bufferSize) {
        super(source);
        if (bufferSize < 1) {
            throw new IllegalArgumentException("a buffer of " + bufferSize + " samples");
        }
        ring = new float[bufferSize][sampleSize];
    }

    /** How many samples it remembers at most. */
    public int getBufferSize() {
        return ring.length;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        System.arraycopy(sample, offset, ring[next], 0, sampleSize);
        next = (next + 1) % ring.length;
        actualSize = Math.min(actualSize + 1, ring.length);
    }

    /** The oldest sample remembered, which the next one will replace; zeros while the buffer is not full. */
    protected void getOldest(float[] sample, int offset) {
        System.arraycopy(ring[next], 0, sample, offset, sampleSize);
    }

    /** How many samples it remembers now. */
    protected int getActualSize() {
        return actualSize;
    }

    /** All values remembered of one element, in no particular order. */
    final float[] valuesOf(int element) {
        float[] values = new float[actualSize];
        for (int i = 0; i < actualSize; i++) {
            values[i] = ring[i][element];
        }
        return values;
    }
}
