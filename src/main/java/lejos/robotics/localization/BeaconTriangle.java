package lejos.robotics.localization;

import lejos.robotics.geometry.Point;
import lejos.robotics.navigation.Pose;

/**
 * Finds a robot's pose from the bearings of three beacons.
 *
 * <p>The robot is where three circles meet, each through two beacons and seen under a known angle; computed as in V.
 * Pierlot and M. Van Droogenbroeck, "A New Three Object Triangulation Algorithm for Mobile Robot Positioning", 2014.
 */
public class BeaconTriangle {
    /** Cotangents of angles nearer to 0 or a half turn than this, in radians, are taken as of this. */
    private static final double LEAST_ANGLE = 1e-9;
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    private final Point beacon1;
    private final Point beacon2;
    private final Point beacon3;

    /** Beacons at three places. */
    public BeaconTriangle(Point beacon1, Point beacon2, Point beacon3) {
        this.beacon1 = beacon1;
        this.beacon2 = beacon2;
        this.beacon3 = beacon3;
    }

    /**
     * The pose from which the beacons are seen so. Not a number if the robot is on the circle through all three.
     *
     * @param a1 bearing of the first beacon in degrees counter-clockwise from the robot's heading
     * @param a2 bearing of the second
     * @param a3 bearing of the third
     */
    public Pose calcPose(double a1, double a2, double a3) {
        double x1 = beacon1.getX() - beacon2.getX();
        double y1 = beacon1.getY() - beacon2.getY();
        double x3 = beacon3.getX() - beacon2.getX();
        double y3 = beacon3.getY() - beacon2.getY();
        double t12 = cotangent(a2 - a1);
        double t23 = cotangent(a3 - a2);
        double t31 = (1 - t12 * t23) / (t12 + t23);
        double c12x = x1 + t12 * y1;
        double c12y = y1 - t12 * x1;
        double c23x = x3 - t23 * y3;
        double c23y = y3 + t23 * x3;
        double c31x = x3 + x1 + t31 * (y3 - y1);
        double c31y = y3 + y1 - t31 * (x3 - x1);
        double k31 = x1 * x3 + y1 * y3 + t31 * (x1 * y3 - x3 * y1);
        double d = (c12x - c23x) * (c23y - c31y) - (c12y - c23y) * (c23x - c31x);
        float x = (float) (beacon2.getX() + k31 * (c12y - c23y) / d);
        float y = (float) (beacon2.getY() + k31 * (c23x - c12x) / d);
        Pose pose = new Pose(x, y, 0);
        pose.setHeading(normalize(pose.angleTo(beacon1) - (float) a1));
        return pose;
    }

    /** Bearings of the three beacons from a pose, in degrees. */
    double[] bearingsFrom(Pose pose) {
        return new double[] {
            pose.relativeBearing(beacon1), pose.relativeBearing(beacon2), pose.relativeBearing(beacon3)
        };
    }

    private static double cotangent(double degrees) {
        double tangent = StrictMath.tan(StrictMath.toRadians(degrees));
        return 1 / (Math.abs(tangent) < LEAST_ANGLE ? Math.copySign(LEAST_ANGLE, tangent) : tangent);
    }

    private static float normalize(float angle) {
        float wrapped = angle % FULL_TURN;
        if (wrapped > HALF_TURN) {
            return wrapped - FULL_TURN;
        }
        return wrapped <= -HALF_TURN ? wrapped + FULL_TURN : wrapped;
    }
}
