package brickless.kernel.hooks;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Formattable;
import java.util.List;
import java.util.Locale;
import java.util.MissingFormatArgumentException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * {@code String.format} and its relatives in rewritten code: in English unless a locale is given, lines end in
 * {@code \n}, and numbers are rounded from their shortest decimal, as JDK 21 and later do it. Per robot.
 */
public final class FormatHooks {
    /** Index, flags, width, precision, conversion with its date prefix. */
    private static final Pattern SPECIFIER =
            Pattern.compile("%(\\d+\\$)?([-#+ 0,(<]*)(\\d+)?(\\.\\d+)?([tT]?[a-zA-Z%])");
    private static final int INDEX = 1;
    private static final int FLAGS = 2;
    private static final int WIDTH = 3;
    private static final int PRECISION = 4;
    private static final int CONVERSION = 5;

    private FormatHooks() {}

    /** {@code String.format(format, arguments)}. */
    public static String format(String format, Object[] arguments) {
        return format(Locale.ENGLISH, format, arguments);
    }

    /** {@code String.format(locale, format, arguments)}. */
    public static String format(Locale locale, String format, Object[] arguments) {
        Matcher specifier = SPECIFIER.matcher(format);
        StringBuilder indexed = new StringBuilder();
        List<Object> converted = new ArrayList<>();
        int ordinary = 0;
        int used = -1;
        while (specifier.find()) {
            String conversion = specifier.group(CONVERSION);
            if ("n".equals(conversion) || "%".equals(conversion)) {
                String text = "n".equals(conversion) ? "\n" : specifier.group();
                specifier.appendReplacement(indexed, Matcher.quoteReplacement(text));
                continue;
            }
            if (specifier.group(INDEX) != null) {
                used = Integer.parseInt(specifier.group(INDEX).replace("$", "")) - 1;
            } else if (specifier.group(FLAGS).indexOf('<') < 0) {
                used = ordinary++;
            }
            converted.add(converted(conversion, argument(arguments, used, specifier.group())));
            specifier.appendReplacement(indexed, Matcher.quoteReplacement(indexed(specifier, converted.size())));
        }
        return String.format(locale, specifier.appendTail(indexed).toString(), converted.toArray());
    }

    private static Object argument(Object[] arguments, int index, String specifier) {
        if (arguments == null) {
            return null;
        }
        if (index < 0 || index >= arguments.length) {
            throw new MissingFormatArgumentException(specifier);
        }
        return arguments[index];
    }

    /** The specifier with an index of its own, so that every use of an argument can have the form that it needs. */
    private static String indexed(Matcher specifier, int index) {
        return "%" + index + "$" + specifier.group(FLAGS).replace("<", "") + orEmpty(specifier.group(WIDTH))
                + orEmpty(specifier.group(PRECISION)) + specifier.group(CONVERSION);
    }

    private static String orEmpty(String part) {
        return part == null ? "" : part;
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

    private static Object converted(String conversion, Object argument) {
        switch (conversion.toLowerCase(Locale.ROOT)) {
            case "s":
                return argument == null || argument instanceof Formattable ? argument : TextHooks.text(argument);
            case "f":
            case "e":
            case "g":
                return argument instanceof Double || argument instanceof Float
                        ? decimal(((Number) argument).doubleValue(), argument) : argument;
            default:
                return argument;
        }
    }

    private static Object decimal(double value, Object original) {
        return value == 0 || !Double.isFinite(value) ? original : new BigDecimal(FloatingText.of(value));
    }
}
