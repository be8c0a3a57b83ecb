package tabletop;

import lejos.hardware.motor.Motor;
import lejos.utility.Delay;

/** Drives about without looking where the table ends. */
public class Blindfold {
    public static void main(String[] args) {
        Motor.B.setSpeed(250);
        Motor.C.setSpeed(200);
        Motor.B.forward();
        Motor.C.forward();
        Delay.msDelay(120000);
    }
}
