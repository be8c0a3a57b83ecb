package kit;

import lejos.hardware.motor.Motor;
import lejos.utility.Delay;

/** Drives off and ends without stopping. */
public final class Leaves {
    private Leaves() {}

    public static void main(String[] args) {
        Motor.B.setSpeed(700);
        Motor.C.setSpeed(700);
        Motor.B.forward();
        Motor.C.forward();
        Delay.msDelay(1000);
    }
}
