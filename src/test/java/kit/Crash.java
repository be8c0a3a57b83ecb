package kit;

import lejos.hardware.lcd.LCD;

/** Draws and prints something, then fails with a cause. */
public final class Crash {
    private Crash() {}

    public static void main(String[] args) {
        LCD.drawString("drawn", 0, 5);
        System.out.println("printed");
        throw new IllegalStateException("arm is jammed", new IllegalArgumentException("port A"));
    }
}
