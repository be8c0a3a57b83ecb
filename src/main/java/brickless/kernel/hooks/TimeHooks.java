package brickless.kernel.hooks;

import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.LocalTime;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.Date;
import java.util.Locale;
import java.util.TimeZone;

/** Dates and times of rewritten code: the robot's clock in UTC. Per robot. */
public final class TimeHooks {
    private static final String[] DAYS = {"Thu", "Fri", "Sat", "Sun", "Mon", "Tue", "Wed"};
    private static final String[] MONTHS =
            {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    private static final int DAYS_A_WEEK = 7;

    private TimeHooks() {}

    /** {@code Clock.systemUTC} and {@code systemDefaultZone}. */
    public static Clock clock() {
        return new VirtualClock(ZoneOffset.UTC);
    }

    /** {@code Clock.system(zone)}. */
    public static Clock clock(ZoneId zone) {
        return new VirtualClock(zone);
    }

    /** {@code Instant.now}. */
    public static Instant instant() {
        return Instant.ofEpochMilli(Hooks.machine().currentTimeMillis());
    }

    /** {@code LocalTime.now}. */
    public static LocalTime localTime() {
        return LocalTime.now(clock());
    }

    /** {@code LocalDate.now}. */
    public static LocalDate localDate() {
        return LocalDate.now(clock());
    }

    /** {@code LocalDateTime.now}. */
    public static LocalDateTime localDateTime() {
        return LocalDateTime.now(clock());
    }

    /** {@code ZonedDateTime.now}. */
    public static ZonedDateTime zonedDateTime() {
        return ZonedDateTime.now(clock());
    }

    /** {@code OffsetDateTime.now}. */
    public static OffsetDateTime offsetDateTime() {
        return OffsetDateTime.now(clock());
    }

    /** {@code ZoneId.systemDefault}. */
    public static ZoneId zone() {
        return ZoneOffset.UTC;
    }

    /** {@code TimeZone.getDefault}. */
    public static TimeZone timeZone() {
        return TimeZone.getTimeZone("UTC");
    }

    /** What {@code date.toString()} gives in UTC, such as {@code Thu Jan 01 00:00:00 UTC 1970}. */
    static String text(Date date) {
        LocalDateTime time = LocalDateTime.ofEpochSecond(Math.floorDiv(date.getTime(), 1000L), 0, ZoneOffset.UTC);
        String day = DAYS[(int) Math.floorMod(time.toLocalDate().toEpochDay(), (long) DAYS_A_WEEK)];
        return String.format(Locale.ROOT, "%s %s %02d %02d:%02d:%02d UTC %d", day, MONTHS[time.getMonthValue() - 1],
                time.getDayOfMonth(), time.getHour(), time.getMinute(), time.getSecond(), time.getYear());
    }

    private static final class VirtualClock extends Clock {
        private final ZoneId zone;

        VirtualClock(ZoneId zone) {
            this.zone = zone;
        }

        @Override
        public ZoneId getZone() {
            return zone;
        }

        @Override
        public Clock withZone(ZoneId other) {
            return new VirtualClock(other);
        }

        @Override
        public long millis() {
            return Hooks.machine().currentTimeMillis();
        }

        @Override
        public Instant instant() {
            return TimeHooks.instant();
        }
    }
}
