package brickless.device.sensor;

import brickless.physics.ObstacleBody;
import brickless.physics.RayHit;
import brickless.units.Angles;

/** Echo of an ultrasonic sensor: the nearest thing in a cone that throws sound back. */
final class SoundBeam {
    /** Half the opening angle of the cone, degrees: assumption (±15 to 20, no measured source). */
    static final double HALF_ANGLE_DEGREES = 15;
    /** Echoes from smooth walls are lost beyond this angle of incidence, degrees: assumption (45 to 50). */
    static final double LARGEST_INCIDENCE_DEGREES = 45;
    /** Longest distance, metres. */
    static final double REACH = 2.55;
    private static final int RAYS = 9;
    private static final double SPACING = Angles.radiansFromDegrees(2 * HALF_ANGLE_DEGREES / (RAYS - 1));
    private static final double LARGEST_INCIDENCE = Angles.radiansFromDegrees(LARGEST_INCIDENCE_DEGREES);

    private static final double[] TURNS = turns();

    private final RayHit hit = new RayHit();
    private final double[] reached = new double[RAYS];

    private static double[] turns() {
        double[] turns = new double[RAYS];
        for (int i = 0; i < RAYS; i++) {
            turns[i] = (i - RAYS / 2) * SPACING;
        }
        return turns;
    }

    /** Distance of the nearest echo in metres, infinite if none comes back. */
    double distance(SensorSite site) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < RAYS; i++) {
            site.surroundings().ray(site.aim(), TURNS[i], REACH, site, hit);
            reached[i] = Math.min(REACH, hit.distanceMetres());
            if (hit.distanceMetres() < nearest && echoes()) {
                nearest = hit.distanceMetres();
            }
        }
        return nearest;
    }

    /** The rays of the last measurement. */
    SensorBeam seen(SensorSite site, double metres) {
        return SensorBeam.of(site.aim(), TURNS, reached, metres);
    }

    /** Walls throw sound back like mirrors; robots are so rugged that some always comes back (assumption). */
    private boolean echoes() {
        return !(hit.solid() instanceof ObstacleBody obstacle)
                || !obstacle.description().soundAbsorbing() && hit.incidenceRadians() <= LARGEST_INCIDENCE;
    }
}
