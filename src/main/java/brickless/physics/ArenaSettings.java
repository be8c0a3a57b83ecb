package brickless.physics;

/**
 * How an arena is computed. The defaults were chosen by measurement, see MODELS.md.
 *
 * @param ideal tyres never slip and gears have no play
 * @param stepNanos length of a step, 100 µs to 10 ms
 * @param velocityIterations rounds in which the solver balances motors, tyres and contacts in each step, 1 to 100
 * @param positionIterations rounds in which it takes overlaps out of contacts in each step, 1 to 100
 */
public record ArenaSettings(boolean ideal, long stepNanos, int velocityIterations, int positionIterations) {
    /** Accurate to a fraction of a millimetre and far from costly. */
    public static final long DEFAULT_STEP_NANOS = 2_000_000;
    /** More change nothing that can be seen. */
    public static final int DEFAULT_VELOCITY_ITERATIONS = 6;
    /** More change nothing that can be seen. */
    public static final int DEFAULT_POSITION_ITERATIONS = 2;
    private static final int MOST_ITERATIONS = 100;

    public ArenaSettings {
        if (stepNanos < 100_000 || stepNanos > 10_000_000) {
            throw new IllegalArgumentException("physics step must be 0.1 to 10 ms, is " + stepNanos + " ns");
        }
        if (Math.min(velocityIterations, positionIterations) < 1
                || Math.max(velocityIterations, positionIterations) > MOST_ITERATIONS) {
            throw new IllegalArgumentException("solver iterations must be 1 to " + MOST_ITERATIONS + ", are "
                    + velocityIterations + " and " + positionIterations);
        }
    }

    /** A step of some length with the default iterations. */
    public ArenaSettings(boolean ideal, long stepNanos) {
        this(ideal, stepNanos, DEFAULT_VELOCITY_ITERATIONS, DEFAULT_POSITION_ITERATIONS);
    }

    /** Default step with or without ideal tyres and gears. */
    public static ArenaSettings of(boolean ideal) {
        return new ArenaSettings(ideal, DEFAULT_STEP_NANOS);
    }
}
