package lejos.robotics.filter;

import java.util.Arrays;
import lejos.robotics.SampleProvider;

/**
 * The integral of samples over the time between fetches, in seconds; each sample counts for the time since the one
 * before.
 */
public class IntegrationFilter extends AbstractFilter {
    private static final double SECONDS_PER_NANO = 1e-9;

    private final float[] integral;
    private long lastNanos;
    private boolean started;

    /** A filter whose integral begins at 0. */
    public IntegrationFilter(SampleProvider source) {
        super(source);
        integral = new float[sampleSize];
    }

    /** Sets the integral of all elements; time counts from the next fetch. */
    public void resetTo(float value) {
        Arrays.fill(integral, value);
        started = false;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        long now = System.nanoTime();
        float seconds = started ? (float) ((now - lastNanos) * SECONDS_PER_NANO) : 0;
        for (int i = 0; i < sampleSize; i++) {
            integral[i] += sample[offset + i] * seconds;
            sample[offset + i] = integral[i];
        }
        lastNanos = now;
        started = true;
    }
}
