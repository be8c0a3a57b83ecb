package brickless.kernel.hooks;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Text of doubles and floats as {@link Double#toString(double)} specifies it since JDK 19: the shortest decimal that
 * reads back as the same number, the closest one among those. Older JDKs sometimes print a digit more, so programs get
 * this text on every JDK. Shared.
 */
public final class FloatingText {
    private static final boolean JDK_IS_SHORTEST = Runtime.version().feature() >= 19;
    /** Two decimals of at most this many digits never read back as the same normal double (or float). */
    private static final int UNAMBIGUOUS_DOUBLE_DIGITS = 15;
    private static final int UNAMBIGUOUS_FLOAT_DIGITS = 6;
    private static final int FEWEST_DIGITS = 2;
    private static final int SMALLEST_PLAIN_EXPONENT = -3;
    private static final int LARGEST_PLAIN_EXPONENT = 6;

    private FloatingText() {}

    /** The text of a double. */
    public static String of(double value) {
        String text = Double.toString(value);
        if (JDK_IS_SHORTEST || !Double.isFinite(value) || value == 0) {
            return text;
        }
        if (Math.abs(value) >= Double.MIN_NORMAL && digits(text) <= UNAMBIGUOUS_DOUBLE_DIGITS) {
            return text;
        }
        return layOut(value < 0, shortest(new BigDecimal(Math.abs(value)), digits(text),
                decimal -> decimal.doubleValue() == Math.abs(value)));
    }

    /** The text of a float. */
    public static String of(float value) {
        String text = Float.toString(value);
        if (JDK_IS_SHORTEST || !Float.isFinite(value) || value == 0) {
            return text;
        }
        if (Math.abs(value) >= Float.MIN_NORMAL && digits(text) <= UNAMBIGUOUS_FLOAT_DIGITS) {
            return text;
        }
        return layOut(value < 0, shortest(new BigDecimal(Math.abs(value)), digits(text),
                decimal -> decimal.floatValue() == Math.abs(value)));
    }

    /** Significant digits of a JDK text, an upper bound for the shortest. */
    private static int digits(String text) {
        int end = text.indexOf('E') < 0 ? text.length() : text.indexOf('E');
        int digits = 0;
        boolean leading = true;
        for (int i = 0; i < end; i++) {
            char c = text.charAt(i);
            if (c >= '1' && c <= '9' || c == '0' && !leading) {
                leading = false;
                digits++;
            }
        }
        return digits;
    }

    private static BigDecimal shortest(BigDecimal exact, int upperBound, Reading reading) {
        int length = Math.max(upperBound, FEWEST_DIGITS);
        BigDecimal best = closest(exact, length, reading);
        while (length > FEWEST_DIGITS) {
            BigDecimal shorter = closest(exact, --length, reading);
            if (shorter == null) {
                break;
            }
            best = shorter;
        }
        return best;
    }

    /**
     * The decimal of {@code length} digits closest to {@code exact} that reads back as the number; null if there is
     * none.
     */
    private static BigDecimal closest(BigDecimal exact, int length, Reading reading) {
        BigDecimal nearest = exact.round(new MathContext(length, RoundingMode.HALF_EVEN));
        if (reading.isSame(nearest)) {
            return nearest;
        }
        BigDecimal above = exact.round(new MathContext(length, RoundingMode.UP));
        return reading.isSame(above) ? above : null;
    }

    /** The JDK's layout: plain from 10^-3 to 10^7, else one digit before the point and an exponent. */
    private static String layOut(boolean negative, BigDecimal decimal) {
        String digits = decimal.unscaledValue().toString();
        int exponent = digits.length() - 1 - decimal.scale();
        int end = digits.length();
        while (end > 1 && digits.charAt(end - 1) == '0') {
            end--;
        }
        digits = digits.substring(0, end);
        StringBuilder text = new StringBuilder();
        if (negative) {
            text.append('-');
        }
        if (exponent >= SMALLEST_PLAIN_EXPONENT && exponent <= LARGEST_PLAIN_EXPONENT) {
            plain(text, digits, exponent);
        } else {
            text.append(digits.charAt(0)).append('.').append(digits.length() > 1 ? digits.substring(1) : "0")
                    .append('E').append(exponent);
        }
        return text.toString();
    }

    private static void plain(StringBuilder text, String digits, int exponent) {
        if (exponent < 0) {
            text.append("0.").append("0".repeat(-exponent - 1)).append(digits);
            return;
        }
        int whole = exponent + 1;
        if (digits.length() <= whole) {
            text.append(digits).append("0".repeat(whole - digits.length())).append(".0");
        } else {
            text.append(digits, 0, whole).append('.').append(digits, whole, digits.length());
        }
    }

    /** Whether a decimal reads back as the number in question. */
    private interface Reading {
        boolean isSame(BigDecimal decimal);
    }
}
