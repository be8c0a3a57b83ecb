package square;

import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.hardware.motor.Motor;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Drives a square of half a metre, one blocking call after the other. */
public class Square {
    private static final double WHEEL_CM = 5.6;
    private static final double TRACK_CM = 12.0;

    public static void main(String[] args) {
        LCD.drawString("ENTER to start", 0, 0);
        Button.ENTER.waitForPressAndRelease();
        LCD.clear();
        Stopwatch watch = new Stopwatch();
        Motor.B.setSpeed(270);
        Motor.C.setSpeed(270);
        Motor.B.setAcceleration(1500);
        Motor.C.setAcceleration(1500);
        for (int side = 1; side <= 4; side++) {
            LCD.drawString("side " + side, 0, 1);
            travel(50);
            turn(90);
        }
        LCD.drawString(watch.elapsed() / 1000 + " s", 0, 2);
        Delay.msDelay(500);
    }

    private static void travel(double cm) {
        int degrees = (int) Math.round(cm / (Math.PI * WHEEL_CM) * 360);
        Motor.B.rotate(degrees, true);
        Motor.C.rotate(degrees);
        Motor.B.waitComplete();
    }

    private static void turn(double degrees) {
        int wheel = (int) Math.round(degrees * TRACK_CM / WHEEL_CM);
        Motor.B.rotate(wheel, true);
        Motor.C.rotate(-wheel);
        Motor.B.waitComplete();
    }
}
