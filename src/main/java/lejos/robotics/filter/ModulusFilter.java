package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/**
 * Turns values into the range from 0 to a modulus, such as 360 degrees, counted from a zero of its own for each
 * element.
 */
public class ModulusFilter extends AbstractFilter {
    private final float[] zero;
    private final float modulus;

    /**
     * A filter.
     *
     * @param source where samples come from
     * @param zeroValue the value of each element that becomes 0; not copied
     * @param modulus end of the range. Values more than this below zero come out negative
     */
    public ModulusFilter(SampleProvider source, float[] zeroValue, float modulus) {
        super(source);
        this.zero = zeroValue;
        this.modulus = modulus;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        for (int i = 0; i < sampleSize; i++) {
            sample[offset + i] = (modulus + sample[offset + i] - zero[i]) % modulus;
        }
    }
}
