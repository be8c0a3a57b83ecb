package brickless.physics;

/**
 * Rays spread evenly over the beam of a sensor, and one more for each obstacle so slender that it could stand between
 * two of them: a chair leg in front of a robot is not missed.
 */
public final class RayFan {
    private final double halfAngle;
    private final double spacing;
    private final double reach;
    /** Obstacles with a larger radius cannot stand between two rays. */
    private final double slender;
    private final double edgeCos;
    private final double edgeSin;
    private final double[] turns;
    private final double[] cosines;
    private final double[] sines;
    private final double[] lengths;
    private final RayHit hit = new RayHit();

    /** Told what rays meet. */
    @FunctionalInterface
    public interface Visitor {
        /** A ray met something; the hit is valid during the call only. */
        void met(RayHit hit);
    }

    /** A fan of an odd number of rays over twice the half angle, in radians, which is less than a right angle. */
    public RayFan(double halfAngleRadians, int rays, double reachMetres) {
        halfAngle = halfAngleRadians;
        spacing = 2 * halfAngleRadians / (rays - 1);
        reach = reachMetres;
        slender = spacing * reachMetres / (1 - spacing);
        edgeCos = StrictMath.cos(halfAngleRadians);
        edgeSin = StrictMath.sin(halfAngleRadians);
        turns = new double[rays];
        cosines = new double[rays];
        sines = new double[rays];
        lengths = new double[rays];
        for (int i = 0; i < rays; i++) {
            turns[i] = (i - rays / 2) * spacing;
            cosines[i] = StrictMath.cos(turns[i]);
            sines[i] = StrictMath.sin(turns[i]);
        }
    }

    /**
     * Casts all rays.
     *
     * @param arena in which
     * @param aim from where
     * @param leastHeightMetres lower obstacles are passed over
     * @param own the robot that casts them, which they ignore; may be null
     * @param visitor told about every ray that meets something
     */
    public void cast(Arena arena, Aim aim, double leastHeightMetres, RobotBody own, Visitor visitor) {
        Sector sector = arena.sector();
        sector.see(leastHeightMetres, own);
        sector.face(aim, edgeCos, edgeSin, reach, slender);
        for (int i = 0; i < turns.length; i++) {
            cast(sector, turns[i], cosines[i], sines[i], visitor);
            lengths[i] = Math.min(reach, hit.distanceMetres());
        }
        for (int i = 0; i < sector.obstacles(); i++) {
            slender(sector, aim, sector.obstacle(i), visitor);
        }
    }

    private void slender(Sector sector, Aim aim, ObstacleBody obstacle, Visitor visitor) {
        double dx = obstacle.centreX() - aim.x;
        double dy = obstacle.centreY() - aim.y;
        double squared = dx * dx + dy * dy;
        double radius = obstacle.radiusMetres();
        boolean mayBeMissed = radius * radius < squared * spacing * spacing;
        if (!mayBeMissed || squared > (reach + radius) * (reach + radius)) {
            return;
        }
        double bearing = StrictMath.IEEEremainder(StrictMath.atan2(dy, dx) - aim.headingRadians, 2 * StrictMath.PI);
        if (Math.abs(bearing) <= halfAngle) {
            cast(sector, bearing, StrictMath.cos(bearing), StrictMath.sin(bearing), visitor);
        }
    }

    private void cast(Sector sector, double turn, double cos, double sin, Visitor visitor) {
        sector.cast(turn, cos, sin, hit);
        if (hit.solid() != null) {
            visitor.met(hit);
        }
    }

    /** Directions of the evenly spread rays against that of the sensor, radians clockwise; not to be changed. */
    public double[] turnsRadians() {
        return turns;
    }

    /** How far the evenly spread rays of the last cast got, metres; not to be changed. */
    public double[] lengthsMetres() {
        return lengths;
    }
}
