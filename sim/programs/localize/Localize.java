package localize;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.FixedRangeScanner;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeFinderAdapter;
import lejos.robotics.RangeScanner;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.localization.MCLPoseProvider;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Pose;

/** Finds out where in a known room it is: moves about, scans, and keeps the guesses that explain what it measures. */
public class Localize {
    private static final int PARTICLES = 300;
    private static final int MOVES = 12;

    /** Distance of the sensor from the axle, less what the scanner adds by itself. */
    private static final float SENSOR_AHEAD_CM = 5.8f;

    private static final float[][] WALLS = { { 0, 0, 150, 0 }, { 150, 0, 150, 60 }, { 150, 60, 90, 60 }, { 90, 60, 90, 110 },
            { 90, 110, 0, 110 }, { 0, 110, 0, 0 } };

    public static void main(String[] args) {
        MovePilot pilot = new MovePilot(new WheeledChassis(new Wheel[] { WheeledChassis.modelWheel(Motor.B, 5.6).offset(6),
                WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6) }, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(120);
        EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(SensorPort.S4);
        RangeFinder ranges = new Ranges(new RangeFinderAdapter(sonar.getDistanceMode()));
        RangeScanner scanner = new FixedRangeScanner(pilot, ranges);
        scanner.setAngles(new float[] { -90, 0, 90, 180 });
        MCLPoseProvider localization = new MCLPoseProvider(null, scanner, room(), PARTICLES, 12);
        for (int i = 0; i < MOVES; i++) {
            Pose pose = localization.getPose();
            System.out.println(pose.getX() + " " + pose.getY() + " " + pose.getHeading() + " " + localization.getXRange() + " "
                    + localization.getYRange());
            if (i < MOVES - 1) {
                move(pilot, localization, ranges);
            }
        }
    }

    /** Only this move counts, not the turns of the scanner, which come back to where they began. */
    private static void move(MovePilot pilot, MCLPoseProvider localization, RangeFinder ranges) {
        pilot.rotate(40);
        apply(pilot, localization, 0, 40);
        float free = ranges.getRange() - 25;
        if (free > 0) {
            float distance = Math.min(15, free);
            pilot.travel(distance);
            apply(pilot, localization, distance, 0);
        }
    }

    private static void apply(MovePilot pilot, MCLPoseProvider localization, float distance, float angle) {
        Move move = new Move(distance, angle, false);
        localization.moveStarted(move, pilot);
        localization.moveStopped(move, pilot);
    }

    private static LineMap room() {
        Line[] lines = new Line[WALLS.length];
        for (int i = 0; i < lines.length; i++) {
            lines[i] = new Line(WALLS[i][0], WALLS[i][1], WALLS[i][2], WALLS[i][3]);
        }
        return new LineMap(lines, new Rectangle(0, 0, 150, 110));
    }

    /** Ranges from the middle of the robot. */
    private static class Ranges implements RangeFinder {
        private final RangeFinder sensor;

        Ranges(RangeFinder sensor) {
            this.sensor = sensor;
        }

        public float getRange() {
            return sensor.getRange() + SENSOR_AHEAD_CM;
        }

        public float[] getRanges() {
            return sensor.getRanges();
        }
    }
}
