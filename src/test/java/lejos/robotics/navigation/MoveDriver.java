package lejos.robotics.navigation;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.Bytes;
import lejos.robotics.RangeReadings;
import lejos.robotics.geometry.Point;
import lejos.robotics.pathfinding.Path;

/** Asks poses, moves and waypoints everything. */
final class MoveDriver {
    private MoveDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        Sightings seen = new Sightings();
        float[] c = new float[6];
        for (int i = 0; i < c.length; i++) {
            c[i] = seed % 3 == 0 ? (random.nextInt(9) - 4) * 45 : random.nextFloat() * 400 - 200;
        }
        poses(seen, c);
        moves(seen, c, random.nextInt(4));
        waypoints(seen, c);
        return seen;
    }

    private static void poses(Sightings seen, float[] c) {
        Pose pose = new Pose(c[0], c[1], c[2]);
        Point there = new Point(c[3], c[4]);
        seen.note("angleTo", pose.angleTo(there)).note("bearing", pose.relativeBearing(there));
        seen.note("distanceTo", pose.distanceTo(there)).note("pointAt", pose.pointAt(c[3], c[5]).x);
        Bytes.note(seen, "pose", pose);
        seen.note("copy", Bytes.copy(pose, new Pose()).getHeading());
        pose.moveUpdate(c[3]);
        note(seen, "moved", pose);
        pose.arcUpdate(c[4], c[5]);
        note(seen, "arc", pose);
        pose.arcUpdate(c[4], c[5] / 400);
        note(seen, "nearly straight", pose);
        pose.rotateUpdate(c[3]);
        pose.translate(c[1], c[2]);
        note(seen, "turned", pose);
        pose.setHeading(c[5] * 10);
        pose.setLocation(c[1], c[2]);
        note(seen, "set", pose);
    }

    private static void moves(Sightings seen, float[] c, int type) {
        note(seen, "plain", new Move(c[0], c[1], true));
        note(seen, "stop", new Move(0, 0, false));
        note(seen, "typed", new Move(Move.MoveType.values()[type], c[0], c[1], c[2], c[3], false));
        note(seen, "short", new Move(Move.MoveType.values()[type], c[0], c[1] / 200, true));
        Move arc = new Move(true, c[1], c[2]);
        note(seen, "arc move", arc);
        arc.setValues(Move.MoveType.TRAVEL, c[3], c[4] / 200, false);
        arc.setDynamics(c[4], c[5]);
        note(seen, "changed", arc);
        note(seen, "move copy", Bytes.copy(arc, new Move(0, 0, true)));
        seen.note("angle", Move.convertDistanceToAngle(c[0], c[1] + 500));
        seen.note("distance", Move.convertAngleToDistance(c[0], c[1]));
    }

    private static void waypoints(Sightings seen, float[] c) {
        Waypoint waypoint = new Waypoint(c[0], c[1], c[2]);
        Bytes.note(seen, "waypoint", waypoint);
        Waypoint plain = new Waypoint(new Point(c[3], c[4]));
        seen.note("required", plain.isHeadingRequired())
                .note("heading", new Waypoint(new Pose(c[0], c[1], c[2])).getHeading());
        note(seen, "pose", Bytes.copy(waypoint, plain).getPose());
        Pose pose = new Pose(c[3], c[4], c[5]);
        seen.note("valid", waypoint.checkValidity(pose))
                .note("error", waypoint.getMaxPositionError() + waypoint.getMaxHeadingError());
        waypoint.setMaxPositionError(150);
        seen.note("near", waypoint.checkValidity(pose));
        waypoint.setMaxHeadingError(90);
        seen.note("near and aligned", waypoint.checkValidity(pose));
        waypoint.setMaxPositionError(-1);
        seen.note("aligned", waypoint.checkValidity(pose));
        Path path = new Path();
        path.add(waypoint);
        path.add(plain);
        Bytes.note(seen, "path", path);
        seen.note("path copy", Bytes.copy(path, new Path()).size());
        RangeReadings readings = new RangeReadings(3);
        seen.note("incomplete", readings.incomplete());
        readings.setRange(1, c[0], c[1]);
        readings.setRange(2, c[2], c[3]);
        Bytes.note(seen, "readings", readings);
        seen.note("at angle", readings.getRange(c[2])).note("second", readings.getRange(1))
                .note("third angle", readings.getAngle(2));
    }

    private static void note(Sightings seen, String label, Move move) {
        Bytes.note(seen, label, move);
        seen.note(label + " moving", move.isMoving()).note(label + " radius", move.getArcRadius());
        seen.note(label + " speeds", move.getTravelSpeed() + 3 * move.getRotateSpeed());
        String text = move.toString();
        seen.note(label + " text", text.replaceAll("[-0-9.E]+", "#").hashCode());
    }

    private static void note(Sightings seen, String label, Pose pose) {
        seen.note(label + ".x", pose.getX()).note(label + ".y", pose.getY())
                .note(label + ".heading", pose.getHeading());
    }
}
