package kit;

import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.utility.Delay;

/** Prints and draws, clears the drawing, and goes on until it is ended. */
public final class Layers {
    private Layers() {}

    public static void main(String[] args) {
        System.out.println("printed");
        LCD.drawString("drawn", 0, 3);
        Delay.msDelay(1000);
        LCD.clear();
        Delay.msDelay(1000);
        LCD.drawString("drawn again", 0, 3);
        while (Button.ESCAPE.isUp()) {
            Delay.msDelay(50);
        }
    }
}
