package busywait;

import lejos.hardware.lcd.LCD;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;

/** Waits for its motors in the two ways people write it: spinning on isMoving() with and without a yield. */
public class BusyWait {
    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        left.setSpeed(360);
        right.setSpeed(360);

        left.rotate(720, true);
        right.rotate(720, true);
        while (left.isMoving() || right.isMoving()) {
            Thread.yield();
        }
        LCD.drawString("yielding: " + left.getTachoCount(), 0, 2);

        left.rotate(-720, true);
        right.rotate(-720, true);
        while (left.isMoving() || right.isMoving())
            ;
        LCD.drawString("spinning: " + left.getTachoCount(), 0, 3);

        System.out.println(left.getTachoCount() + " " + right.getTachoCount());
        left.close();
        right.close();
    }
}
