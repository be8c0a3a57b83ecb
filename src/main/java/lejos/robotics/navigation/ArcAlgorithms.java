package lejos.robotics.navigation;

import lejos.robotics.geometry.Point;

/**
 * Ways for a robot that cannot turn on the spot: arcs of a circle and straight lines.
 *
 * <p>A radius is positive if the centre is to the left. Angles are in degrees; of an arc, the change of heading. Where
 * there is no way, results are not a number.
 */
public class ArcAlgorithms {
    private static final float FULL_TURN = 360;
    private static final float QUARTER_TURN = 90;

    /** A cosine may exceed 1 by so much because of rounding. */
    private static final double COSINE_SLACK = 1.1;

    private ArcAlgorithms() {}

    /**
     * The shortest of all ways to a pose, with turns to either side.
     *
     * @param radius1 radius of the first arc; the sign does not matter
     * @param radius2 radius of the last arc; the sign does not matter
     * @return arc, line and arc; null if there is no way
     */
    public static Move[] getBestPath(Pose start, float radius1, Pose destination, float radius2) {
        Move[][] best = new Move[4][];
        for (int signs = 0; signs < best.length; signs++) {
            float first = (signs & 2) == 0 ? radius1 : -radius1;
            float last = (signs & 1) == 0 ? radius2 : -radius2;
            best[signs] = getBestPath(getAvailablePaths(start, first, destination, last));
        }
        return getBestPath(best);
    }

    /**
     * The four ways to a pose, each of an arc, a line that is driven forward, and an arc: both arcs forward, the last
     * backward, the first backward, both backward.
     */
    public static Move[][] getAvailablePaths(Pose start, float radius1, Pose destination, float radius2) {
        Point center1 = findCircleCenter(start.getLocation(), radius1, start.getHeading());
        Point center2 = findCircleCenter(destination.getLocation(), radius2, destination.getHeading());
        double distance = center1.distance(center2);
        double widening = (double) radius2 - radius1;
        float line = (float) Math.sqrt(distance * distance - widening * widening);
        double apart = StrictMath.toDegrees(StrictMath.asin(widening / distance));
        float direction = (float) (center1.angleTo(center2) - apart);
        Point leave = findPointOnHeading(center1, direction - QUARTER_TURN, radius1);
        Point meet = findPointOnHeading(center2, direction - QUARTER_TURN, radius2);
        float first = getArc(start.getLocation(), leave, radius1, start.getHeading(), true);
        float last = getArc(meet, destination.getLocation(), radius2, direction, true);
        float[][] arcs = {{first, last}, {first, getArcBackward(last)}, {getArcBackward(first), last},
            {getArcBackward(first), getArcBackward(last)}};
        Move[][] paths = new Move[arcs.length][];
        for (int i = 0; i < arcs.length; i++) {
            paths[i] = new Move[] {new Move(false, arcs[i][0], radius1), new Move(line, 0, false),
                new Move(false, arcs[i][1], radius2)};
        }
        return paths;
    }

    /**
     * The four ways to a point, each of an arc and a line that is driven forward: arc to the left forward, backward, to
     * the right forward, backward, where left is what the sign of the radius says.
     */
    public static Move[][] getAvailablePaths(Pose start, Point destination, float r) {
        Move[][] paths = new Move[4][];
        for (int i = 0; i < paths.length; i += 2) {
            float radius = i == 0 ? r : -r;
            Point center = findCircleCenter(start.getLocation(), radius, start.getHeading());
            Point leave = findP2(center, destination, radius);
            float arc = getArc(start.getLocation(), leave, radius, start.getHeading(), true);
            float line = distBetweenPoints(leave, destination);
            paths[i] = new Move[] {new Move(false, arc, radius), new Move(line, 0, false)};
            paths[i + 1] = new Move[] {new Move(false, getArcBackward(arc), radius), new Move(line, 0, false)};
        }
        return paths;
    }

    /** The shortest way to a point, an arc and a line; null if there is none. */
    public static Move[] getBestPath(Pose start, Point destination, float r) {
        return getBestPath(getAvailablePaths(start, destination, r));
    }

    /** The shortest of some ways; null if there is none. */
    public static Move[] getBestPath(Move[][] paths) {
        Move[] best = null;
        float least = Float.POSITIVE_INFINITY;
        for (Move[] path : paths) {
            float length = path == null ? Float.NaN : length(path);
            if (length < least) {
                least = length;
                best = path;
            }
        }
        return best;
    }

    private static float length(Move[] path) {
        float length = 0;
        for (Move move : path) {
            length += Math.abs(move.getDistanceTraveled());
        }
        return length;
    }

    /** The point at a distance in a direction. */
    public static Point findPointOnHeading(Point original, float heading, float distance) {
        double radians = StrictMath.toRadians(heading);
        return new Point((float) (original.x + distance * StrictMath.cos(radians)),
                (float) (original.y + distance * StrictMath.sin(radians)));
    }

    /** The angle at the first of three points, 0 to 180. */
    public static float getTriangleAngle(Point p1, Point p2, Point pa) {
        double side = p1.distance(p2);
        double other = p1.distance(pa);
        double opposite = p2.distance(pa);
        double cosine = (side * side + other * other - opposite * opposite) / (2 * side * other);
        if (Math.abs(cosine) > 1 && Math.abs(cosine) < COSINE_SLACK) {
            cosine = Math.signum(cosine);
        }
        return (float) StrictMath.toDegrees(StrictMath.acos(cosine));
    }

    /** A heading after a change of less than a turn, from 0 to, not including, 360. */
    public static float getHeading(float oldHeading, float changeInHeading) {
        float heading = oldHeading + changeInHeading;
        if (heading >= FULL_TURN) {
            return heading - FULL_TURN;
        }
        return heading < 0 ? heading + FULL_TURN : heading;
    }

    /**
     * The arc from one point of a circle to another.
     *
     * @param radius radius of the circle
     * @param heading heading at the first point
     * @param forward whether to drive forward
     */
    public static float getArc(Point p1, Point p2, float radius, float heading, boolean forward) {
        Point ahead = findPointOnHeading(p1, heading, 2 * Math.abs(radius));
        float turn = 2 * getTriangleAngle(p1, p2, ahead);
        float arc = radius < 0 ? -turn : turn;
        return forward ? arc : getArcBackward(arc);
    }

    /** The arc that leads to the same point the other way round. */
    public static float getArcBackward(float forwardArc) {
        if (forwardArc > 0) {
            return forwardArc - FULL_TURN;
        }
        return forwardArc < 0 ? forwardArc + FULL_TURN : 0;
    }

    /**
     * The shorter arc between two points of a circle.
     *
     * @deprecated use {@link #getArc}, which knows the heading
     */
    @Deprecated
    public static double getArcOld(Point p1, Point p2, double radius) {
        return 2 * StrictMath.toDegrees(StrictMath.asin(p1.distance(p2) / (2 * radius)));
    }

    /** Distance of two points. */
    public static float distBetweenPoints(Point a, Point b) {
        return (float) a.distance(b);
    }

    /** Direction from one point to another, from 0 to, not including, 360. */
    public static float getHeading(Point from, Point to) {
        if (from.x == to.x && from.y == to.y) {
            return Float.NaN;
        }
        return getHeading(from.angleTo(to), 0);
    }

    /** The point where the tangent to a point leaves a circle. */
    public static Point findP2(Point c, Point p3, float radius) {
        double apart = StrictMath.toDegrees(StrictMath.acos(Math.abs(radius) / c.distance(p3)));
        double bearing = radius > 0 ? c.angleTo(p3) - apart : c.angleTo(p3) + apart;
        return findPointOnHeading(c, (float) bearing, Math.abs(radius));
    }

    /** The centre of the circle of a radius that a robot at a point with a heading drives on. */
    public static Point findCircleCenter(Point p, float radius, float heading) {
        return findPointOnHeading(p, heading + QUARTER_TURN, radius);
    }
}
