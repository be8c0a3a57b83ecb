package waypoints;

import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.NavigationListener;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;

/** Follows a path of five waypoints and prints each one it reaches. */
public class Waypoints implements NavigationListener {
    public static void main(String[] args) {
        Wheel left = WheeledChassis.modelWheel(Motor.B, 5.6).offset(6);
        Wheel right = WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6);
        MovePilot pilot = new MovePilot(new WheeledChassis(new Wheel[] { left, right }, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(25);
        pilot.setAngularSpeed(90);
        Navigator navigator = new Navigator(pilot);
        navigator.addNavigationListener(new Waypoints());
        navigator.addWaypoint(50, 0);
        navigator.addWaypoint(50, 40);
        navigator.addWaypoint(100, 40);
        navigator.addWaypoint(80, -30);
        navigator.addWaypoint(0, 0, 180);
        navigator.followPath();
        System.out.println("done " + navigator.waitForStop());
    }

    public void atWaypoint(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("reached " + sequence + " at " + pose);
    }

    public void pathComplete(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("complete " + sequence);
    }

    public void pathInterrupted(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("interrupted " + sequence);
    }
}
