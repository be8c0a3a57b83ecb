package obstacles;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;

/** Knows the obstacle course by heart: drives from gap to gap by odometry. Centimetres from the start, ahead and to the left. */
public class PlannedRoute {
    private static final double DIAMETER = 5.6;
    private static final double TRACK = 12;
    private static final int[][] GAPS = {{26, 18}, {70, 18}, {82, -11}, {130, -11}, {148, 6}, {171, 6}, {171, -55}, {244, -55}};

    public static void main(String[] args) {
        Wheel left = WheeledChassis.modelWheel(new EV3LargeRegulatedMotor(MotorPort.B), DIAMETER).offset(TRACK / 2);
        Wheel right = WheeledChassis.modelWheel(new EV3LargeRegulatedMotor(MotorPort.C), DIAMETER).offset(-TRACK / 2);
        Chassis chassis = new WheeledChassis(new Wheel[] {left, right}, WheeledChassis.TYPE_DIFFERENTIAL);
        MovePilot pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(15);
        pilot.setLinearAcceleration(20);
        pilot.setAngularSpeed(45);
        pilot.setAngularAcceleration(90);
        Navigator navigator = new Navigator(pilot, new OdometryPoseProvider(pilot));
        for (int[] gap : GAPS) {
            navigator.addWaypoint(gap[0], gap[1]);
        }
        navigator.followPath();
        navigator.waitForStop();
        System.out.println(navigator.getPoseProvider().getPose());
    }
}
