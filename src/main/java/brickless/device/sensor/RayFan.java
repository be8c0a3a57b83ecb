package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.physics.ObstacleBody;
import brickless.physics.RayHit;
import java.util.List;

/**
 * Rays spread evenly over the beam of a sensor, and one more for each obstacle so slender that it could stand between
 * two of them: a chair leg in front of a robot is not missed.
 */
final class RayFan {
    private final double halfAngle;
    private final int rays;
    private final double spacing;
    private final double reach;
    private final double[] turns;
    private final double[] reached;
    private final RayHit hit = new RayHit();

    /** Told what rays meet. */
    @FunctionalInterface
    interface Visitor {
        /** A ray met something; the hit is valid during the call only. */
        void met(RayHit hit);
    }

    /** A fan of an odd number of rays over twice the half angle, in radians. */
    RayFan(double halfAngleRadians, int rays, double reachMetres) {
        this.halfAngle = halfAngleRadians;
        this.rays = rays;
        this.spacing = 2 * halfAngleRadians / (rays - 1);
        this.reach = reachMetres;
        this.turns = new double[rays];
        this.reached = new double[rays];
        for (int i = 0; i < rays; i++) {
            turns[i] = (i - rays / 2) * spacing;
        }
    }

    /** Casts all rays from a sensor's present place. */
    void cast(SensorSite site, Visitor visitor) {
        Aim aim = site.aim();
        for (int i = 0; i < rays; i++) {
            ray(site, aim, turns[i], visitor);
            reached[i] = Math.min(reach, hit.distanceMetres());
        }
        List<ObstacleBody> obstacles = site.surroundings().arena().obstacles();
        for (int i = 0; i < obstacles.size(); i++) {
            slender(site, aim, obstacles.get(i), visitor);
        }
    }

    /** The evenly spread rays of the last cast, for those who look at the sensor. */
    SensorBeam seen(SensorSite site, double metres) {
        return SensorBeam.of(site.aim(), turns, reached, metres);
    }

    private void slender(SensorSite site, Aim aim, ObstacleBody obstacle, Visitor visitor) {
        double dx = obstacle.centreX() - aim.x;
        double dy = obstacle.centreY() - aim.y;
        double squared = dx * dx + dy * dy;
        double radius = obstacle.radiusMetres();
        boolean mayBeMissed = radius * radius < squared * spacing * spacing;
        if (!mayBeMissed || squared > (reach + radius) * (reach + radius) || !obstacle.present()) {
            return;
        }
        double bearing = StrictMath.IEEEremainder(StrictMath.atan2(dy, dx) - aim.headingRadians, 2 * StrictMath.PI);
        if (Math.abs(bearing) <= halfAngle) {
            ray(site, aim, bearing, visitor);
        }
    }

    private void ray(SensorSite site, Aim aim, double bearing, Visitor visitor) {
        site.surroundings().ray(aim, bearing, reach, site, hit);
        if (hit.solid() != null) {
            visitor.met(hit);
        }
    }
}
