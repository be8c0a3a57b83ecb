package lejos.hardware.sensor;

import lejos.robotics.SampleProvider;

/** Samples as tests take them. */
final class Samples {
    private Samples() {}

    static float[] fetch(SampleProvider source) {
        float[] sample = new float[source.sampleSize()];
        source.fetchSample(sample, 0);
        return sample;
    }
}
