package brickless.units;

/** Times: virtual time is counted in whole nanoseconds; models use seconds, the leJOS API milliseconds. */
public final class Times {
    /** Nanoseconds in a second. */
    public static final long NANOS_PER_SECOND = 1_000_000_000L;
    /** Nanoseconds in a millisecond. */
    public static final long NANOS_PER_MILLISECOND = 1_000_000L;
    /** Nanoseconds in a microsecond. */
    public static final long NANOS_PER_MICROSECOND = 1_000L;

    private Times() {}

    /** Nanoseconds to seconds. */
    public static double secondsFromNanos(long nanos) {
        return nanos / (double) NANOS_PER_SECOND;
    }

    /** Seconds to the nearest whole nanosecond; beyond the range of {@code long} the nearest end of it. */
    public static long nanosFromSeconds(double seconds) {
        return Math.round(seconds * NANOS_PER_SECOND);
    }

    /**
     * Milliseconds to nanoseconds; throws {@link ArithmeticException} beyond the range of {@code long} (about 292
     * years).
     */
    public static long nanosFromMilliseconds(long milliseconds) {
        return Math.multiplyExact(milliseconds, NANOS_PER_MILLISECOND);
    }

    /** Microseconds to nanoseconds; throws {@link ArithmeticException} beyond the range of {@code long}. */
    public static long nanosFromMicroseconds(long microseconds) {
        return Math.multiplyExact(microseconds, NANOS_PER_MICROSECOND);
    }

    /** Nanoseconds to whole milliseconds, rounded towards negative infinity like a clock reading. */
    public static long millisecondsFromNanos(long nanos) {
        return Math.floorDiv(nanos, NANOS_PER_MILLISECOND);
    }
}
