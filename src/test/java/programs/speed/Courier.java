package programs.speed;

import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;

/** Goes round three waypoints for ever with a pilot and a navigator. */
public class Courier {
    /** Runs for ever. */
    public static void main(String[] args) {
        Wheel left = WheeledChassis.modelWheel(Motor.B, 5.6).offset(5.7);
        Wheel right = WheeledChassis.modelWheel(Motor.C, 5.6).offset(-5.7);
        MovePilot pilot = new MovePilot(
                new WheeledChassis(new Wheel[] {left, right}, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(90);
        Navigator navigator = new Navigator(pilot);
        while (true) {
            navigator.addWaypoint(20, 0);
            navigator.addWaypoint(20, -20);
            navigator.addWaypoint(0, 0);
            navigator.followPath();
            navigator.waitForStop();
        }
    }
}
