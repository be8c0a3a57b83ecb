package lejos.robotics;

import lejos.robotics.filter.AbstractFilter;

/** A distance mode as a {@link RangeFinder}. Beware of the units, which are those of leJOS. */
public class RangeFinderAdapter extends AbstractFilter implements RangeFinder {
    private static final float CENTIMETRES_PER_METRE = 100;

    /**
     * An adapter.
     *
     * @param source distances in metres
     */
    public RangeFinderAdapter(SampleProvider source) {
        super(source);
    }

    /** The first distance, in <b>centimetres</b>. */
    @Override
    public float getRange() {
        return getRanges()[0] * CENTIMETRES_PER_METRE;
    }

    /** All distances, in <b>metres</b>. */
    @Override
    public float[] getRanges() {
        float[] sample = new float[sampleSize];
        fetchSample(sample, 0);
        return sample;
    }
}
