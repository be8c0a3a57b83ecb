package brickless.physics;

/**
 * How an arena is computed.
 *
 * @param ideal tyres never slip
 * @param stepNanos length of a step, 500 µs to 5 ms
 */
public record ArenaSettings(boolean ideal, long stepNanos) {
    /**
     * The step that was chosen by measurement, see MODELS.md: accurate to a fraction of a millimetre and far from
     * costly.
     */
    public static final long DEFAULT_STEP_NANOS = 2_000_000;

    public ArenaSettings {
        if (stepNanos < 500_000 || stepNanos > 5_000_000) {
            throw new IllegalArgumentException("physics step must be 0.5 to 5 ms, is " + stepNanos + " ns");
        }
    }

    /** Default step with or without ideal tyres. */
    public static ArenaSettings of(boolean ideal) {
        return new ArenaSettings(ideal, DEFAULT_STEP_NANOS);
    }
}
