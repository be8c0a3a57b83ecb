package brickless.concurrent;

import java.util.Random;

/**
 * {@code java.util.concurrent.ThreadLocalRandom}: one generator for all threads of the robot, seeded from the robot's
 * random stream.
 */
public final class ThreadLocalRandom extends Random {
    private static final long serialVersionUID = 1L;
    private static final ThreadLocalRandom INSTANCE = new ThreadLocalRandom(new Random().nextLong());

    private final boolean seeded;

    private ThreadLocalRandom(long seed) {
        super(seed);
        seeded = true;
    }

    /** The generator. */
    public static ThreadLocalRandom current() {
        return INSTANCE;
    }

    /** Not possible, as in the original: throws UnsupportedOperationException. */
    @Override
    public void setSeed(long seed) {
        if (seeded) {
            throw new UnsupportedOperationException();
        }
        super.setSeed(seed);
    }

    /** A number from {@code origin} up to but not including {@code bound}. */
    @Override
    public double nextDouble(double origin, double bound) {
        if (!(origin < bound) || Double.isInfinite(bound - origin)) {
            throw new IllegalArgumentException("bound must be greater than origin");
        }
        double value = nextDouble() * (bound - origin) + origin;
        return value < bound ? value : Math.nextDown(bound);
    }

    /** A number from 0 up to but not including {@code bound}. */
    @Override
    public double nextDouble(double bound) {
        return nextDouble(0, bound);
    }
}
