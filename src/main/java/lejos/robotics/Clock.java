package lejos.robotics;

import java.io.IOException;

/** A real-time clock with battery-backed memory. All methods throw {@link IOException} if the clock does not answer. */
public interface Clock {
    /** The year. */
    int getYear() throws IOException;

    /** The month, 1 to 12. */
    int getMonth() throws IOException;

    /** The day of the month, 1 to 31. */
    int getDay() throws IOException;

    /** The hour, 0 to 23 or 1 to 12 as {@link #setHourMode} chose. */
    int getHour() throws IOException;

    /** The minute, 0 to 59. */
    int getMinute() throws IOException;

    /** The second, 0 to 59. */
    int getSecond() throws IOException;

    /** The day of the week, 1 to 7. */
    int getDayOfWeek() throws IOException;

    /** Chooses between counting hours to 12 and to 24. */
    void setHourMode(boolean mode) throws IOException;

    /** The date as text. */
    String getDateString() throws IOException;

    /** The time of day as text. */
    String getTimeString() throws IOException;

    /** {@code AM} or {@code PM}. */
    String getAMPM() throws IOException;

    /** One byte of the clock's memory. */
    byte getByte(int location) throws IndexOutOfBoundsException, IOException;

    /** Writes one byte of the clock's memory. */
    void setByte(int location, byte value) throws IndexOutOfBoundsException, IOException;

    /** Sets the date. */
    void setDate(int month, int day, int year) throws IllegalArgumentException, IOException;

    /** Sets the time of day. */
    void setTime(int hour, int minute, int second) throws IllegalArgumentException, IOException;
}
