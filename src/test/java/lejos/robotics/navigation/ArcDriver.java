package lejos.robotics.navigation;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.geometry.Point;

/** Asks for ways between random poses. */
final class ArcDriver {
    private final Sightings seen = new Sightings();

    private ArcDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        Pose start = pose(random);
        Pose end = pose(random);
        float radius = (20 + random.nextInt(60)) * (random.nextBoolean() ? 1 : -1);
        ArcDriver driver = new ArcDriver();
        driver.note("to point", ArcAlgorithms.getAvailablePaths(start, end.getLocation(), radius));
        driver.note("to pose", ArcAlgorithms.getAvailablePaths(start, radius, end,
                random.nextBoolean() ? radius : -radius));
        driver.length("best to point", ArcAlgorithms.getBestPath(start, end.getLocation(), radius));
        driver.length("best to pose", ArcAlgorithms.getBestPath(start, radius, end, radius));
        driver.geometry(start, end, radius);
        return driver.seen;
    }

    private static Pose pose(Random random) {
        return new Pose(random.nextFloat() * 400 - 200, random.nextFloat() * 400 - 200, random.nextFloat() * 360 - 180);
    }

    private void geometry(Pose start, Pose end, float radius) {
        Point a = start.getLocation();
        Point b = end.getLocation();
        point("tangent", ArcAlgorithms.findP2(a, b, radius));
        point("center", ArcAlgorithms.findCircleCenter(a, radius, start.getHeading()));
        point("ahead", ArcAlgorithms.findPointOnHeading(a, start.getHeading(), radius));
        seen.note("distance", ArcAlgorithms.distBetweenPoints(a, b)).note("heading", ArcAlgorithms.getHeading(a, b));
        seen.note("triangle", ArcAlgorithms.getTriangleAngle(a, b, new Point(radius, 5)));
        seen.note("changed", ArcAlgorithms.getHeading(end.getHeading(), start.getHeading()));
        seen.note("other way", ArcAlgorithms.getArcBackward(start.getHeading()));
    }

    private void note(String label, Move[][] paths) {
        for (int i = 0; i < paths.length; i++) {
            for (int j = 0; j < paths[i].length; j++) {
                String name = label + " " + i + j;
                Move move = paths[i][j];
                // A whole turn and none are the same arc, and which of them it is hangs on the last digit.
                seen.note(name + " angle", Math.cos(Math.toRadians(move.getAngleTurned())));
                seen.note(name + " radius", move.getArcRadius());
                seen.note(name + " length", j == 1 ? move.getDistanceTraveled() : 0);
            }
        }
    }

    private void length(String label, Move[] path) {
        float length = 0;
        for (Move move : path) {
            length += Math.abs(move.getDistanceTraveled());
        }
        seen.note(label, length).note(label + " pieces", path.length);
    }

    private void point(String label, Point point) {
        seen.note(label + " x", point.x).note(label + " y", point.y);
    }
}
