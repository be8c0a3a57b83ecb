package brickless.device.sensor;

import brickless.physics.ObstacleBody;
import brickless.physics.RayFan;
import brickless.physics.RayHit;
import brickless.units.Angles;

/** Echo of an ultrasonic sensor: the nearest thing in a cone that throws sound back. */
final class SoundBeam implements RayFan.Visitor {
    /** Half the opening angle of the cone, degrees: assumption (±15 to 20, no measured source). */
    static final double HALF_ANGLE_DEGREES = 15;
    /** Echoes from smooth walls are lost beyond this angle of incidence, degrees: assumption (45 to 50). */
    static final double LARGEST_INCIDENCE_DEGREES = 45;
    /** Longest distance, metres. */
    static final double REACH = 2.55;
    private static final int RAYS = 9;
    private static final double LARGEST_INCIDENCE = Angles.radiansFromDegrees(LARGEST_INCIDENCE_DEGREES);

    private final RayFan fan = new RayFan(Angles.radiansFromDegrees(HALF_ANGLE_DEGREES), RAYS, REACH);
    private double nearest;

    /** Distance of the nearest echo in metres, infinite if none comes back. */
    double distance(SensorSite site) {
        nearest = Double.POSITIVE_INFINITY;
        site.cast(fan, this);
        return nearest;
    }

    @Override
    public void met(RayHit hit) {
        if (hit.distanceMetres() < nearest && echoes(hit)) {
            nearest = hit.distanceMetres();
        }
    }

    /** The rays of the last measurement. */
    SensorBeam seen(SensorSite site, double metres) {
        return SensorBeam.of(site.aim(), fan.turnsRadians(), fan.lengthsMetres(), metres);
    }

    /** Walls throw sound back like mirrors; robots are so rugged that some always comes back (assumption). */
    private static boolean echoes(RayHit hit) {
        return !(hit.solid() instanceof ObstacleBody obstacle)
                || !obstacle.description().soundAbsorbing() && hit.incidenceRadians() <= LARGEST_INCIDENCE;
    }
}
