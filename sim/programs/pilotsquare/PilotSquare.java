package pilotsquare;

import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Pose;

/** Drives a square of one metre to the left with a pilot, and prints where it believes to be at each corner. */
public class PilotSquare {
    private static final double WHEEL_CM = 5.6;
    private static final double HALF_TRACK_CM = 6.0;

    public static void main(String[] args) {
        Wheel left = WheeledChassis.modelWheel(Motor.B, WHEEL_CM).offset(HALF_TRACK_CM);
        Wheel right = WheeledChassis.modelWheel(Motor.C, WHEEL_CM).offset(-HALF_TRACK_CM);
        Chassis chassis = new WheeledChassis(new Wheel[] { left, right }, WheeledChassis.TYPE_DIFFERENTIAL);
        MovePilot pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(25);
        pilot.setLinearAcceleration(50);
        pilot.setAngularSpeed(90);
        pilot.setAngularAcceleration(180);
        chassis.getPoseProvider().setPose(new Pose(0, 0, 0));
        for (int side = 1; side <= 4; side++) {
            pilot.travel(100);
            pilot.rotate(90);
            System.out.println(side + ": " + chassis.getPoseProvider().getPose());
        }
    }
}
