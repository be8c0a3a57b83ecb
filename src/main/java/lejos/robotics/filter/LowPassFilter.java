package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/** A first-order low-pass filter over the time between fetches. The first sample passes unchanged. */
public class LowPassFilter extends AbstractFilter {
    private static final float SECONDS_PER_MILLI = 1e-3f;

    private final float[] smooth;
    private float timeConstant;
    private long lastMillis;
    private boolean started;

    /**
     * A filter.
     *
     * @param source where samples come from
     * @param timeConstant seconds after which about two thirds of a step have come through; 0 = no filtering
     */
    public LowPassFilter(SampleProvider source, float timeConstant) {
        super(source);
        smooth = new float[sampleSize];
        setTimeConstant(timeConstant);
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        long now = System.currentTimeMillis();
        float weight = weight(now);
        for (int i = 0; i < sampleSize; i++) {
            smooth[i] += weight * (sample[offset + i] - smooth[i]);
            sample[offset + i] = smooth[i];
        }
        lastMillis = now;
        started = true;
    }

    /** Sets the time constant in seconds; 0 = no filtering. */
    public void setTimeConstant(float timeConstant) {
        this.timeConstant = timeConstant;
    }

    /** Forgets all samples: the next passes unchanged. */
    final void restart() {
        started = false;
    }

    private float weight(long now) {
        if (!started || timeConstant == 0) {
            return 1;
        }
        float seconds = (now - lastMillis) * SECONDS_PER_MILLI;
        return seconds / (timeConstant + seconds);
    }
}
