package kit;

import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Prints samples. */
final class Samples {
    private Samples() {}

    /** One sample after a pause that is long enough for every sensor's latency. */
    static void print(String name, SampleProvider source) {
        source.fetchSample(new float[source.sampleSize()], 0);
        Delay.msDelay(120);
        System.out.println(name + text(source));
    }

    /** First values of samples taken every {@code periodMillis}. */
    static void series(String name, SampleProvider source, int count, int periodMillis) {
        float[] sample = new float[source.sampleSize()];
        StringBuilder line = new StringBuilder(name);
        for (int i = 0; i < count; i++) {
            source.fetchSample(sample, 0);
            line.append(' ').append(sample[0]);
            Delay.msDelay(periodMillis);
        }
        System.out.println(line);
    }

    /**
     * Polls without pause for a second: number of reads, number of changes, shortest time between changes in
     * milliseconds.
     */
    static void updates(String name, SampleProvider source) {
        float[] sample = new float[source.sampleSize()];
        long end = System.currentTimeMillis() + 1000;
        long lastChange = 0;
        long shortest = Long.MAX_VALUE;
        float last = Float.NaN;
        int reads = 0;
        int changes = 0;
        while (System.currentTimeMillis() < end) {
            source.fetchSample(sample, 0);
            reads++;
            if (sample[0] != last) {
                long now = System.currentTimeMillis();
                shortest = changes > 1 ? Math.min(shortest, now - lastChange) : shortest;
                lastChange = now;
                last = sample[0];
                changes++;
            }
        }
        System.out.println(name + " " + reads + " " + changes + " " + shortest);
    }

    private static String text(SampleProvider source) {
        float[] sample = new float[source.sampleSize()];
        source.fetchSample(sample, 0);
        StringBuilder text = new StringBuilder();
        for (float value : sample) {
            text.append(' ').append(value);
        }
        return text.toString();
    }
}
