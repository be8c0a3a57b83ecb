package brickless.kernel.hooks;

import java.text.DateFormatSymbols;
import java.text.SimpleDateFormat;
import java.util.Locale;

/**
 * What {@code new SimpleDateFormat} becomes in a rewritten program: UTC, and English unless the program says otherwise.
 * Per robot.
 */
public class ProgramDateFormat extends SimpleDateFormat {
    private static final long serialVersionUID = 1L;

    /** Short date and time. */
    public ProgramDateFormat() {
        this("M/d/yy, h:mm a");
    }

    /** A pattern. */
    public ProgramDateFormat(String pattern) {
        this(pattern, LocaleHooks.locale());
    }

    /** A pattern in some language. */
    public ProgramDateFormat(String pattern, Locale locale) {
        super(pattern, locale);
        setTimeZone(TimeHooks.timeZone());
    }

    /** A pattern with words of the program's own. */
    public ProgramDateFormat(String pattern, DateFormatSymbols symbols) {
        this(pattern);
        setDateFormatSymbols(symbols);
    }
}
