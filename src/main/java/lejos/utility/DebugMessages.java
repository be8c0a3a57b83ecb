package lejos.utility;

import lejos.hardware.lcd.LCD;

/**
 * Writes messages on the screen, one row after the other. When the rows are used up the screen is cleared, and the
 * message that found no row is lost, as in leJOS.
 */
public class DebugMessages {
    private static final int LAST_ROW = 7;
    private static final int DEFAULT_DELAY_MILLIS = 250;

    private int row;
    private int rows = LAST_ROW;
    private int delayMillis = DEFAULT_DELAY_MILLIS;
    private boolean delayEnabled;

    /** Starts at the top row. */
    public DebugMessages() {
        this(0);
    }

    /** Starts at the given row. */
    public DebugMessages(int init) {
        row = init;
    }

    /** Sets the last row; values above 7 are ignored. */
    public void setLCDLines(int lines) {
        if (lines <= LAST_ROW) {
            rows = lines;
        }
    }

    /** Whether to wait after each message. */
    public void setDelayEnabled(boolean de) {
        delayEnabled = de;
    }

    /** Sets the wait after each message in milliseconds. */
    public void setDelay(int ms) {
        delayMillis = ms;
    }

    /** Writes a message. */
    public void echo(String message) {
        if (row > rows) {
            clear();
        } else {
            LCD.drawString(message, 0, row++);
            LCD.refresh();
        }
        if (delayEnabled) {
            Delay.msDelay(delayMillis);
        }
    }

    /** Writes a number. */
    public void echo(int i) {
        echo(Integer.toString(i));
    }

    /** Clears the screen and starts at the top row. */
    public void clear() {
        LCD.clear();
        row = 0;
        LCD.refresh();
    }
}
