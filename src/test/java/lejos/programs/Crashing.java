package lejos.programs;

import lejos.hardware.lcd.LCD;
import lejos.utility.Delay;

/** One thread dies of an exception while main goes on. */
public final class Crashing {
    private Crashing() {}

    public static void main(String[] args) {
        LCD.drawString("alive", 0, 3);
        new Thread(() -> {
            throw new IllegalStateException("broken");
        }).start();
        Delay.msDelay(1000);
        System.out.println("main went on");
    }
}
