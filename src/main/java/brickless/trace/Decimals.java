package brickless.trace;

/**
 * Decimal text of measured numbers with a fixed number of places.
 *
 * <p>{@code Double.toString} gives different digits on different JDKs; this does not.
 */
public final class Decimals {
    private static final long[] POWERS = {1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000};

    private Decimals() {}

    /**
     * Text of {@code value} rounded to {@code places} (0 to 9) decimals, without trailing zeros and without a negative zero.
     * Infinities and NaN give {@code null}, as JSON has no such numbers.
     */
    public static String text(double value, int places) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return "null";
        }
        return scaled(Math.round(value * POWERS[places]), places);
    }

    /** Text of nanoseconds as seconds with six decimals at most. */
    public static String seconds(long nanos) {
        return scaled(nanos / 1_000, 6);
    }

    private static String scaled(long value, int places) {
        if (value == 0) {
            return "0";
        }
        long magnitude = Math.abs(value);
        StringBuilder text = new StringBuilder(20);
        if (value < 0) {
            text.append('-');
        }
        text.append(magnitude / POWERS[places]);
        long fraction = magnitude % POWERS[places];
        if (fraction != 0) {
            text.append('.');
            for (int place = places - 1; fraction != 0; place--) {
                text.append((char) ('0' + fraction / POWERS[place]));
                fraction %= POWERS[place];
            }
        }
        return text.toString();
    }
}
