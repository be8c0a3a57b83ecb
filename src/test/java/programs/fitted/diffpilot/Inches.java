package programs.fitted.diffpilot;

import lejos.hardware.motor.Motor;
import lejos.robotics.navigation.DifferentialPilot;

/** An old NXT program: a differential pilot in inches. */
@SuppressWarnings("deprecation")
public class Inches {
    DifferentialPilot pilot;

    public static void main(String[] args) {
        Inches traveler = new Inches();
        traveler.pilot = new DifferentialPilot(2.25f, 5.5f, Motor.C, Motor.B);
        traveler.go();
    }

    public void go() {
        pilot.setLinearSpeed(6);
        pilot.setAngularSpeed(60);
        pilot.travel(20);
        pilot.rotate(90);
        pilot.travel(10, true);
        while (pilot.isMoving()) {
            Thread.yield();
        }
    }
}
