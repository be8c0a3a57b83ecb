package brickless.trace;

import java.nio.charset.StandardCharsets;

/**
 * Decimal text of measured numbers with a fixed number of places.
 *
 * <p>{@code Double.toString} gives different digits on different JDKs; this does not.
 */
public final class Decimals {
    private static final long[] POWERS = {1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000,
            1_000_000_000};

    /** A sign, all digits of a {@code long}, and a point. */
    static final int MOST_BYTES = 21;

    private Decimals() {}

    /**
     * Text of {@code value} rounded to {@code places} (0 to 9) decimals, without trailing zeros and without a negative
     * zero. Infinities and NaN give {@code null}, as JSON has no such numbers.
     */
    public static String text(double value, int places) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return "null";
        }
        return scaled(Math.round(value * POWERS[places]), places);
    }

    /** A number rounded to {@code places} decimals, in units of the last one. */
    static long rounded(double value, int places) {
        return Math.round(value * POWERS[places]);
    }

    /** Appends {@code value} units of the last of {@code places} decimals; the same text as {@link #text}. */
    static int put(long value, int places, byte[] out, int at) {
        int end = at;
        if (value < 0) {
            out[end++] = '-';
        }
        long magnitude = Math.abs(value);
        end = putWhole(magnitude / POWERS[places], out, end);
        long fraction = magnitude % POWERS[places];
        if (fraction != 0) {
            out[end++] = '.';
            for (int place = places - 1; fraction != 0; place--) {
                out[end++] = (byte) ('0' + fraction / POWERS[place]);
                fraction %= POWERS[place];
            }
        }
        return end;
    }

    private static int putWhole(long value, byte[] out, int at) {
        int digits = 1;
        for (long rest = value / 10; rest > 0; rest /= 10) {
            digits++;
        }
        long rest = value;
        for (int i = at + digits - 1; i >= at; i--) {
            out[i] = (byte) ('0' + rest % 10);
            rest /= 10;
        }
        return at + digits;
    }

    /** Text of nanoseconds as seconds with six decimals at most. */
    public static String seconds(long nanos) {
        return scaled(nanos / 1_000, 6);
    }

    private static String scaled(long value, int places) {
        byte[] text = new byte[MOST_BYTES];
        return new String(text, 0, put(value, places, text, 0), StandardCharsets.US_ASCII);
    }
}
