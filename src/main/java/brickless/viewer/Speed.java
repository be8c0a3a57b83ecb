package brickless.viewer;

import java.util.Optional;

/** Speeds of a live run: simulated seconds per second; infinite is as fast as it goes. */
public final class Speed {
    /** As fast as it goes. */
    public static final double MAX = Double.POSITIVE_INFINITY;
    private static final double SLOWEST = 0.1;
    private static final double FASTEST = 100;

    private Speed() {}

    /** Reads {@code max} or a number with or without {@code x} behind it; empty if it is neither or out of range. */
    public static Optional<Double> parse(String text) {
        if (text.equals("max")) {
            return Optional.of(MAX);
        }
        if (!text.matches("\\d{1,3}(\\.\\d{1,6})?x?")) {
            return Optional.empty();
        }
        double value = Double.parseDouble(text.replace("x", ""));
        return valid(value) ? Optional.of(value) : Optional.empty();
    }

    static boolean valid(double value) {
        return value == MAX || value >= SLOWEST && value <= FASTEST;
    }

    static double check(double value) {
        if (!valid(value)) {
            throw new IllegalArgumentException("a speed is 0.1 to 100 or \"max\"");
        }
        return value;
    }
}
