package brickless.kernel.hooks;

import java.util.Calendar;
import java.util.GregorianCalendar;
import java.util.Locale;
import java.util.TimeZone;

/**
 * What {@code new GregorianCalendar} and {@code Calendar.getInstance} become in a rewritten program: the robot's clock,
 * UTC, English. Per robot.
 */
public class ProgramCalendar extends GregorianCalendar {
    private static final long serialVersionUID = 1L;

    /** Now. */
    public ProgramCalendar() {
        this(TimeHooks.timeZone(), LocaleHooks.locale());
    }

    /** Now, in a time zone. */
    public ProgramCalendar(TimeZone zone) {
        this(zone, LocaleHooks.locale());
    }

    /** Now, with a locale's first day of the week. */
    public ProgramCalendar(Locale locale) {
        this(TimeHooks.timeZone(), locale);
    }

    /** Now. */
    public ProgramCalendar(TimeZone zone, Locale locale) {
        super(zone, locale);
        setTimeInMillis(Hooks.machine().currentTimeMillis());
    }

    /** Midnight of a date. */
    public ProgramCalendar(int year, int month, int dayOfMonth) {
        this(year, month, dayOfMonth, 0, 0, 0);
    }

    /** A date and time. */
    public ProgramCalendar(int year, int month, int dayOfMonth, int hourOfDay, int minute) {
        this(year, month, dayOfMonth, hourOfDay, minute, 0);
    }

    /** A date and time. */
    public ProgramCalendar(int year, int month, int dayOfMonth, int hourOfDay, int minute, int second) {
        super(TimeHooks.timeZone(), LocaleHooks.locale());
        clear();
        set(year, month, dayOfMonth, hourOfDay, minute, second);
    }

    /** {@code Calendar.getInstance()}. */
    public static Calendar getInstance() {
        return new ProgramCalendar();
    }

    /** {@code Calendar.getInstance(zone)}. */
    public static Calendar getInstance(TimeZone zone) {
        return new ProgramCalendar(zone);
    }

    /** {@code Calendar.getInstance(locale)}. */
    public static Calendar getInstance(Locale locale) {
        return new ProgramCalendar(locale);
    }

    /** {@code Calendar.getInstance(zone, locale)}. */
    public static Calendar getInstance(TimeZone zone, Locale locale) {
        return new ProgramCalendar(zone, locale);
    }
}
