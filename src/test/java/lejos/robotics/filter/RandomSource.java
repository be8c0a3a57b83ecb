package lejos.robotics.filter;

import java.util.Random;
import lejos.robotics.SampleProvider;

/** A source of seeded random samples. */
final class RandomSource implements SampleProvider {
    private final Random random;
    private final int size;
    private final float lowest;

    RandomSource(int seed, int size, float lowest) {
        this.random = new Random(seed);
        this.size = size;
        this.lowest = lowest;
    }

    @Override
    public int sampleSize() {
        return size;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        for (int i = 0; i < size; i++) {
            sample[offset + i] = lowest + random.nextInt(1000) / 8f;
        }
    }
}
