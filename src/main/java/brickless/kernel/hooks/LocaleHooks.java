package brickless.kernel.hooks;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.text.DecimalFormatSymbols;
import java.text.NumberFormat;
import java.util.Locale;
import java.util.Scanner;

/** Defaults of language and encoding in rewritten code: English, UTF-8, lines that end in {@code \n}. Per robot. */
public final class LocaleHooks {
    private LocaleHooks() {}

    /** {@code Locale.getDefault}. */
    public static Locale locale() {
        return Locale.ENGLISH;
    }

    /** {@code Locale.getDefault(category)}. */
    public static Locale locale(Locale.Category category) {
        return Locale.ENGLISH;
    }

    /** {@code Charset.defaultCharset}. */
    public static Charset charset() {
        return StandardCharsets.UTF_8;
    }

    /** The name of the default encoding. */
    public static String charsetName() {
        return "UTF-8";
    }

    /** False, for constructors that take "no automatic flush" before the encoding. */
    public static boolean no() {
        return false;
    }

    /** Signs that {@code new DecimalFormat(pattern)} uses. */
    public static DecimalFormatSymbols symbols() {
        return DecimalFormatSymbols.getInstance(Locale.ENGLISH);
    }

    /** {@code NumberFormat.getInstance} and {@code getNumberInstance}. */
    public static NumberFormat numberFormat() {
        return NumberFormat.getInstance(Locale.ENGLISH);
    }

    /** {@code NumberFormat.getIntegerInstance}. */
    public static NumberFormat integerFormat() {
        return NumberFormat.getIntegerInstance(Locale.ENGLISH);
    }

    /** {@code NumberFormat.getPercentInstance}. */
    public static NumberFormat percentFormat() {
        return NumberFormat.getPercentInstance(Locale.ENGLISH);
    }

    /** {@code text.toUpperCase()}. */
    public static String toUpperCase(String text) {
        return text.toUpperCase(Locale.ENGLISH);
    }

    /** {@code text.toLowerCase()}. */
    public static String toLowerCase(String text) {
        return text.toLowerCase(Locale.ENGLISH);
    }

    /** {@code text.getBytes()}. */
    public static byte[] getBytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** {@code writer.newLine()}. */
    public static void newLine(BufferedWriter writer) throws IOException {
        writer.write('\n');
    }

    /** {@code scanner.nextDouble()}. */
    public static double nextDouble(Scanner scanner) {
        return english(scanner).nextDouble();
    }

    /** {@code scanner.nextFloat()}. */
    public static float nextFloat(Scanner scanner) {
        return english(scanner).nextFloat();
    }

    /** {@code scanner.hasNextDouble()}. */
    public static boolean hasNextDouble(Scanner scanner) {
        return english(scanner).hasNextDouble();
    }

    /** {@code scanner.hasNextFloat()}. */
    public static boolean hasNextFloat(Scanner scanner) {
        return english(scanner).hasNextFloat();
    }

    /** A scanner still in the host's language reads English numbers. */
    private static Scanner english(Scanner scanner) {
        return scanner.locale().equals(Locale.getDefault(Locale.Category.FORMAT)) ? scanner.useLocale(Locale.ENGLISH)
                : scanner;
    }
}
