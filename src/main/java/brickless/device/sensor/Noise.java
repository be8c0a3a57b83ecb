package brickless.device.sensor;

/**
 * Seeded noise as a function of an update number, so that reading a sensor more often, or not at all, changes no value.
 * Integer arithmetic only (the finaliser of SplitMix64): the same on every machine.
 */
final class Noise {
    /** No noise at all. */
    static final Noise NONE = new Noise(0, 0);

    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private final long seed;
    private final double strength;

    private Noise(long seed, double strength) {
        this.seed = seed;
        this.strength = strength;
    }

    /** Noise of one device of one robot. */
    static Noise of(long simulationSeed, String robot, int port) {
        long hash = simulationSeed;
        for (int i = 0; i < robot.length(); i++) {
            hash = mix(hash * 31 + robot.charAt(i));
        }
        return new Noise(mix(hash + GOLDEN * (port + 1)), 1);
    }

    /** Evenly spread from −1 to 1. */
    double even(long index, int lane) {
        return strength * (2 * unit(index, lane) - 1);
    }

    /** Bell-shaped with standard deviation 1, never beyond ±3: the sum of six even values. */
    double bell(long index, int lane) {
        double sum = 0;
        for (int i = 0; i < 6; i++) {
            sum += unit(index, lane * 6 + i);
        }
        return strength * (sum - 3) * Math.sqrt(2);
    }

    private double unit(long index, int lane) {
        return (mix(seed + index * GOLDEN + lane * 0xD1B54A32D192ED03L) >>> 11) * 0x1p-53;
    }

    private static long mix(long value) {
        long z = (value ^ value >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
