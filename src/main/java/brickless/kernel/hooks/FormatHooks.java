package brickless.kernel.hooks;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.util.Formattable;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * {@code String.format} and its relatives in rewritten code: in English unless a locale is given, lines end in {@code \n}, and numbers are
 * rounded from their shortest decimal, as JDK 21 and later do it. Per robot.
 */
public final class FormatHooks {
    /** Index, flags, width, precision, conversion with its date prefix. */
    private static final Pattern SPECIFIER = Pattern.compile("%(\\d+\\$)?([-#+ 0,(<]*)(\\d+)?(\\.\\d+)?([tT]?[a-zA-Z%])");
    private static final int INDEX = 1;
    private static final int FLAGS = 2;
    private static final int CONVERSION = 5;

    private FormatHooks() {}

    /** {@code String.format(format, arguments)}. */
    public static String format(String format, Object[] arguments) {
        return format(Locale.ENGLISH, format, arguments);
    }

    /** {@code String.format(locale, format, arguments)}. */
    public static String format(Locale locale, String format, Object[] arguments) {
        return String.format(locale, withPlainLineEnds(format), converted(format, arguments));
    }

    /** {@code stream.printf(format, arguments)} and {@code stream.format}. */
    public static PrintStream printf(PrintStream stream, String format, Object[] arguments) {
        stream.print(format(format, arguments));
        return stream;
    }

    /** {@code stream.printf(locale, format, arguments)} and {@code stream.format}. */
    public static PrintStream printf(PrintStream stream, Locale locale, String format, Object[] arguments) {
        stream.print(format(locale, format, arguments));
        return stream;
    }

    /** {@code writer.printf(format, arguments)} and {@code writer.format}. */
    public static PrintWriter printf(PrintWriter writer, String format, Object[] arguments) {
        writer.print(format(format, arguments));
        return writer;
    }

    /** {@code writer.printf(locale, format, arguments)} and {@code writer.format}. */
    public static PrintWriter printf(PrintWriter writer, Locale locale, String format, Object[] arguments) {
        writer.print(format(locale, format, arguments));
        return writer;
    }

    private static String withPlainLineEnds(String format) {
        Matcher matcher = SPECIFIER.matcher(format);
        StringBuilder text = new StringBuilder();
        while (matcher.find()) {
            boolean lineEnd = "n".equals(matcher.group(CONVERSION));
            matcher.appendReplacement(text, lineEnd ? "\n" : Matcher.quoteReplacement(matcher.group()));
        }
        return matcher.appendTail(text).toString();
    }

    /** The arguments with numbers as their conversions need them. An argument that two kinds of conversion use keeps the first one's form. */
    private static Object[] converted(String format, Object[] arguments) {
        if (arguments == null) {
            return null;
        }
        Object[] result = arguments.clone();
        boolean[] seen = new boolean[arguments.length];
        Matcher matcher = SPECIFIER.matcher(format);
        int ordinary = 0;
        int last = -1;
        while (matcher.find()) {
            String conversion = matcher.group(CONVERSION);
            if ("n".equals(conversion) || "%".equals(conversion)) {
                continue;
            }
            if (matcher.group(INDEX) != null) {
                last = Integer.parseInt(matcher.group(INDEX).replace("$", "")) - 1;
            } else if (matcher.group(FLAGS).indexOf('<') < 0) {
                last = ordinary++;
            }
            if (last >= 0 && last < result.length && !seen[last]) {
                seen[last] = true;
                result[last] = converted(conversion.toLowerCase(Locale.ROOT), result[last]);
            }
        }
        return result;
    }

    private static Object converted(String conversion, Object argument) {
        switch (conversion) {
            case "s":
                return argument == null || argument instanceof Formattable ? argument : TextHooks.text(argument);
            case "f":
            case "e":
            case "g":
                return argument instanceof Double || argument instanceof Float ? decimal(((Number) argument).doubleValue(), argument) : argument;
            default:
                return argument;
        }
    }

    private static Object decimal(double value, Object original) {
        return value == 0 || !Double.isFinite(value) ? original : new BigDecimal(FloatingText.of(value));
    }
}
