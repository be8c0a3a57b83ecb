package programs.passing.clock;

import java.text.SimpleDateFormat;
import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.util.Calendar;
import java.util.Date;
import java.util.GregorianCalendar;
import java.util.Locale;
import java.util.TimeZone;
import java.util.function.Supplier;

/**
 * Every clock of the JDK shows the program's own time, in UTC.
 *
 * @expected exited 0
 * @prints Thu Jan 01 00:00:01 UTC 2015
 * @prints date: Thu Jan 01 00:00:01 UTC 2015
 * @prints 2015 0 1 0:0:1
 * @prints 2015-01-01T00:00:01
 * @prints 2015-01-01 true true
 * @prints 0.0
 * @prints 00:00:01
 */
public class Dates {
    public static void main(String[] args) throws InterruptedException {
        Thread.sleep(1000);
        Date date = new Date();
        System.out.println(date);
        Supplier<Date> now = Date::new;
        System.out.println("date: " + now.get());
        Calendar calendar = Calendar.getInstance();
        System.out.println(calendar.get(Calendar.YEAR) + " " + calendar.get(Calendar.MONTH) + " "
                + new GregorianCalendar().get(Calendar.DATE)
                + " " + calendar.get(Calendar.HOUR_OF_DAY) + ":" + calendar.get(Calendar.MINUTE) + ":"
                + calendar.get(Calendar.SECOND));
        System.out.println(LocalDateTime.now().withNano(0));
        System.out.println(LocalDate.now() + " " + (Instant.now().toEpochMilli() - System.currentTimeMillis() < 2)
                + " " + (Clock.systemUTC().millis() - System.currentTimeMillis() < 2));
        System.out.println(TimeZone.getDefault().getRawOffset() / 1.0);
        SimpleDateFormat format = new SimpleDateFormat("HH:mm:ss", Locale.ENGLISH);
        System.out.println(format.format(date));
    }
}
