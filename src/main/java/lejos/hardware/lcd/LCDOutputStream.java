package lejos.hardware.lcd;

import java.io.OutputStream;

/**
 * Writes characters on a text display like a terminal: wraps at the right edge and scrolls at the bottom. Bytes are
 * Latin-1 characters.
 */
public class LCDOutputStream extends OutputStream {
    private static final int TAB = 8;

    private final TextLCD display;
    private int column;
    private int row;

    /** Writes on a display, from its top left. */
    public LCDOutputStream(TextLCD lcd) {
        display = lcd;
    }

    /** Writes on the display that {@link LCD} draws on, from its top left. */
    public LCDOutputStream() {
        this(LCD.t);
    }

    @Override
    public void write(int b) {
        char character = (char) (b & 0xff);
        switch (character) {
            case '\n' -> newLine();
            case '\r' -> column = 0;
            case '\t' -> column = (column / TAB + 1) * TAB;
            case '\f' -> home();
            default -> put(character);
        }
    }

    private void put(char character) {
        if (column >= display.getTextWidth()) {
            newLine();
        }
        display.drawChar(character, column++, row);
    }

    private void newLine() {
        column = 0;
        if (row + 1 < display.getTextHeight()) {
            row++;
        } else {
            display.scroll();
        }
        display.refresh();
    }

    private void home() {
        display.clear();
        column = 0;
        row = 0;
        display.refresh();
    }
}
