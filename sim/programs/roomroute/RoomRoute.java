package roomroute;

import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.pathfinding.Path;
import lejos.robotics.pathfinding.ShortestPathFinder;

/** Finds the shortest way around mapped walls and drives it. Coordinates are centimetres from where the robot starts. */
public class RoomRoute {
    /** Room that the robot needs beside the end of a wall. */
    private static final float CLEARANCE_CM = 18;

    public static void main(String[] args) throws DestinationUnreachableException {
        Line[] walls = { new Line(40, -60, 40, 20), new Line(90, -10, 90, 70), new Line(140, -60, 140, 15),
                new Line(-30, -60, 190, -60), new Line(190, -60, 190, 70), new Line(190, 70, -30, 70), new Line(-30, 70, -30, -60) };
        ShortestPathFinder finder = new ShortestPathFinder(new LineMap(walls, new Rectangle(-30, -60, 220, 130)));
        finder.lengthenLines(CLEARANCE_CM);
        MovePilot pilot = new MovePilot(new WheeledChassis(new Wheel[] { WheeledChassis.modelWheel(Motor.B, 5.6).offset(6),
                WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6) }, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(25);
        pilot.setAngularSpeed(90);
        Navigator navigator = new Navigator(pilot);
        Path path = finder.findRoute(new Pose(0, 0, 0), new Waypoint(170, -20));
        for (Waypoint waypoint : path) {
            System.out.println((int) waypoint.x + " " + (int) waypoint.y);
        }
        navigator.followPath(path);
        System.out.println("done " + navigator.waitForStop());
    }
}
