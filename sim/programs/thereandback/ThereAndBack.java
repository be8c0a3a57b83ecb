package thereandback;

import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Pose;
import lejos.utility.Delay;

/** Drives forward, in curves and backward, and prints after each move where two kinds of odometry believe to be, in millimetres. */
public class ThereAndBack {
    private final WheeledChassis chassis = new WheeledChassis(new Wheel[] { WheeledChassis.modelWheel(Motor.B, 56).offset(60),
            WheeledChassis.modelWheel(Motor.C, 56).offset(-60) }, WheeledChassis.TYPE_DIFFERENTIAL);
    private final MovePilot pilot = new MovePilot(chassis);
    private final PoseProvider byMoves = new OdometryPoseProvider(pilot);
    private final PoseProvider byWheels = chassis.getPoseProvider();

    public static void main(String[] args) {
        new ThereAndBack().drive();
    }

    private void drive() {
        pilot.setLinearSpeed(200);
        pilot.setAngularSpeed(90);
        pilot.setLinearAcceleration(400);
        pilot.setAngularAcceleration(180);
        pilot.travel(600);
        print("forward");
        pilot.travel(-400);
        print("backward");
        pilot.arc(200, 90);
        print("left");
        pilot.arc(-150, 60);
        print("right");
        pilot.arc(200, -45);
        print("left backward");
        pilot.rotate(-100);
        print("turn");
        pilot.backward();
        Delay.msDelay(1500);
        pilot.stop();
        print("back");
    }

    private void print(String move) {
        Delay.msDelay(300);
        System.out.println(move + text(byMoves.getPose()) + text(byWheels.getPose()));
    }

    private static String text(Pose pose) {
        return " | " + pose.getX() + " " + pose.getY() + " " + pose.getHeading();
    }
}
