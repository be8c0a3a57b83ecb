package lejos.robotics.chassis;

/**
 * How fast to go along an arc: the highest speeds, belonging together, that exceed neither limit.
 *
 * @param linear units per second (or per second squared)
 * @param angular degrees per second (or per second squared)
 */
record ArcPace(double linear, double angular) {
    /** The pace along an arc of a finite radius other than 0, within a linear and an angular limit. */
    static ArcPace within(double linearLimit, double angularLimit, double radius) {
        double distancePerDegree = StrictMath.toRadians(Math.abs(radius));
        double linear = Math.min(linearLimit, angularLimit * distancePerDegree);
        return new ArcPace(linear, linear / distancePerDegree);
    }
}
