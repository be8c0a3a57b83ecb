package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.ProgramLog;
import java.io.OutputStream;
import lejos.hardware.lcd.LCD;
import lejos.hardware.lcd.LCDOutputStream;

/**
 * Duplicates what the program prints to the console and to the screen. It takes the time of drawing the text: a row of
 * the screen about half a millisecond, whether it is full or ended early.
 */
final class PrintedBytes extends OutputStream {
    private static final int COLUMNS = LCD.DISPLAY_CHAR_WIDTH;
    private static final int CHARACTER_PIXELS = LCD.CELL_WIDTH * LCD.CELL_HEIGHT;

    private final ProgramLog log;
    private final LCDOutputStream screen;
    private final boolean error;
    private int column;

    PrintedBytes(ProgramLog log, LCDOutputStream screen, boolean error) {
        this.log = log;
        this.screen = screen;
        this.error = error;
    }

    @Override
    public void write(int value) {
        write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) {
        log.printed(bytes, offset, length, error);
        int cells = 0;
        for (int i = offset; i < offset + length; i++) {
            screen.write(bytes[i]);
            cells += cells(bytes[i]);
        }
        BrickAccess.brick().screen().drawn(cells * CHARACTER_PIXELS);
    }

    /** How many cells of the screen a character costs: the end of a line costs the rest of its row. */
    private int cells(byte character) {
        if (character != '\n') {
            column++;
            return 1;
        }
        int rest = column > 0 && column % COLUMNS == 0 ? 0 : COLUMNS - column % COLUMNS;
        column = 0;
        return rest;
    }
}
