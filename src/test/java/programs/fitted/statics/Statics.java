package programs.fitted.statics;

import lejos.hardware.Button;
import lejos.hardware.motor.Motor;
import lejos.utility.Delay;

/** Ready-made motors and bare numbers: five turns of the wheels ahead, a quarter turn to the right, five turns back. */
public class Statics {
    public static void main(String[] args) {
        System.out.println("Press a button");
        Button.waitForAnyPress();
        Motor.A.setSpeed(360);
        Motor.D.setSpeed(360);
        drive(1800);
        Motor.A.rotate(193, true);
        Motor.D.rotate(-193);
        Motor.A.waitComplete();
        Delay.msDelay(200);
        drive(-1800);
    }

    static void drive(int degrees) {
        Motor.A.rotate(degrees, true);
        Motor.D.rotate(degrees);
        Motor.A.waitComplete();
    }
}
