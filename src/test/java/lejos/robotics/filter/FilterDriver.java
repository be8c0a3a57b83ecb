package lejos.robotics.filter;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.SampleProvider;

/** Runs every filter that does not depend on time, where the published one works. */
final class FilterDriver {
    private static final int FETCHES = 40;

    private FilterDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        int size = 1 + random.nextInt(3);
        int length = 1 + random.nextInt(12);
        float modulus = 50 + random.nextInt(300);
        float[] zero = {random.nextInt(100), random.nextInt(100), random.nextInt(100)};
        Sightings seen = new Sightings();
        record(seen, "sum", new SumFilter(source(seed, size), length), 0);
        record(seen, "mean", new MeanFilter(source(seed, size), length), 0);
        record(seen, "minimum", new MinimumFilter(source(seed, size), length), 2);
        record(seen, "maximum", new MaximumFilter(source(seed, size), length), 2);
        record(seen, "modulus", new ModulusFilter(source(seed, size), zero, modulus), 1);
        record(seen, "zero", new ZeroFilter(source(seed, size), zero), 1);
        record(seen, "slice", new SliceFilter(source(seed, 3), 3 - size, 2), 1);
        record(seen, "both", new ConcatenationFilter(source(seed, size), source(seed + 1, 2)), 1);
        record(seen, "buffer", new Oldest(source(seed, size), length), 1);
        record(seen, "low pass off", new LowPassFilter(source(seed, size), 0), 1);
        offsetCorrection(seen, new OffsetCorrectionFilter(source(seed, size), zero, 20 + length));
        calibration(seen, "offset ", new LinearCalibrationFilter(source(seed, size)), seed, 0);
        calibration(seen, "scale ", new LinearCalibrationFilter(source(seed, size)), seed, 1);
        return seen;
    }

    private static SampleProvider source(int seed, int size) {
        return new RandomSource(seed, size, 0);
    }

    private static void record(Sightings seen, String name, SampleProvider filter, int offset) {
        float[] sample = new float[offset + filter.sampleSize()];
        for (int fetch = 0; fetch < FETCHES; fetch++) {
            filter.fetchSample(sample, offset);
            for (int i = 0; i < sample.length; i++) {
                seen.note(name + " " + fetch + "[" + i + "]", sample[i]);
            }
        }
    }

    private static void offsetCorrection(Sightings seen, OffsetCorrectionFilter filter) {
        record(seen, "drift", filter, 1);
        note(seen, "drift mean", filter.getMean());
        note(seen, "drift deviation", filter.getStandardDeviation());
        filter.reset();
        record(seen, "drift again", filter, 0);
    }

    private static void calibration(Sightings seen, String name, LinearCalibrationFilter filter, int seed, int type) {
        record(seen, name + "before", filter, 1);
        filter.setCalibrationType(type);
        if (seed % 2 == 0) {
            filter.setScaleCalibration(-5, 5 + seed);
        } else {
            filter.setOffsetCalibration(seed);
        }
        filter.startCalibration();
        record(seen, name + "during", filter, 1);
        note(seen, name + "offset so far", filter.getOffsetCorrection());
        filter.suspendCalibration();
        record(seen, name + "suspended", filter, 1);
        filter.resumeCalibration();
        record(seen, name + "resumed", filter, 1);
        filter.stopCalibration();
        record(seen, name + "after", filter, 1);
        note(seen, name + "offset", filter.getOffsetCorrection());
        note(seen, name + "scale", filter.getScaleCorrection());
        seen.note(name + "type", filter.getCalibrationType() + 10 * filter.getCallibrationType());
    }

    private static void note(Sightings seen, String name, float[] values) {
        for (int i = 0; i < values.length; i++) {
            seen.note(name + "[" + i + "]", values[i]);
        }
    }

    private static final class Oldest extends SampleBuffer {
        Oldest(SampleProvider source, int size) {
            super(source, size);
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            super.fetchSample(sample, offset);
            getOldest(sample, offset);
            sample[offset] += 1000 * getActualSize() + 100000 * getBufferSize();
        }
    }
}
