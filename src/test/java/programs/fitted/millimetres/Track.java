package programs.fitted.millimetres;

import lejos.hardware.Brick;
import lejos.hardware.BrickFinder;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;

/** A navigator in millimetres with geared wheels whose motors are mounted backwards. */
public class Track {
    static Brick brick = BrickFinder.getDefault();

    public static void main(String[] args) {
        Wheel wheel1 = WheeledChassis.modelWheel(new EV3LargeRegulatedMotor(brick.getPort("B")), 81.6).offset(-70)
                .gearRatio(3).invert(true);
        Wheel wheel2 = WheeledChassis.modelWheel(new EV3LargeRegulatedMotor(brick.getPort("C")), 81.6).offset(70)
                .gearRatio(3).invert(true);
        Chassis chassis = new WheeledChassis(new Wheel[] {wheel1, wheel2}, WheeledChassis.TYPE_DIFFERENTIAL);
        MovePilot pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(120);
        pilot.setAngularSpeed(60);
        Navigator navigator = new Navigator(pilot, new OdometryPoseProvider(pilot));
        navigator.addWaypoint(400, 0);
        navigator.addWaypoint(400, 300);
        navigator.followPath();
        navigator.waitForStop();
    }
}
