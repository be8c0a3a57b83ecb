package lejos.internal.ev3;

import brickless.hardware.ProgramLog;
import java.io.OutputStream;
import lejos.hardware.lcd.LCDOutputStream;

/** Duplicates what the program prints to the console and to the screen. Never blocks. */
final class PrintedBytes extends OutputStream {
    private final ProgramLog log;
    private final LCDOutputStream screen;
    private final boolean error;

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
        for (int i = offset; i < offset + length; i++) {
            screen.write(bytes[i]);
        }
    }
}
