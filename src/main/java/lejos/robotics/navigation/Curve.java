package lejos.robotics.navigation;

/**
 * How two wheels turn to drive a curve.
 *
 * @param outside the wheel on the longer way
 * @param inside the other one
 * @param ratio way of the inner wheel as a share of the outer one's; negative if it turns the other way
 * @param outsideSpeed speed of the outer motor in degrees per second
 * @param insideSpeed speed of the inner motor in degrees per second, 0 or more
 * @param outsideShare share of the acceleration that the outer motor is to use
 * @param insideShare share of the acceleration that the inner motor is to use
 */
record Curve(DriveWheel outside, DriveWheel inside, double ratio, int outsideSpeed, int insideSpeed,
        double outsideShare, double insideShare) {
    private static final double LEAST_SHARE = 0.1;

    /** The curve for a speed of the outer wheel; the motors' accelerations make both get there at the same time. */
    static Curve of(DriveWheel outside, DriveWheel inside, double ratio, double linearSpeed, int direction) {
        double outsideTarget = linearSpeed * outside.degPerDistance();
        double insideTarget = linearSpeed * ratio * inside.degPerDistance();
        double outsideChange = Math.abs(direction * outsideTarget - outside.rotationSpeed());
        double insideChange = Math.abs(direction * insideTarget - inside.rotationSpeed());
        return new Curve(outside, inside, ratio, (int) outsideTarget, (int) Math.abs(insideTarget),
                share(outsideChange, insideChange), share(insideChange, outsideChange));
    }

    private static double share(double change, double other) {
        double share = change / other;
        return share >= LEAST_SHARE && share < 1 ? share : 1;
    }

    /** Sets the motors' speeds and, as shares of one in units per second squared, accelerations. */
    void prepare(double acceleration) {
        outside.motor().setSpeed(outsideSpeed);
        inside.motor().setSpeed(insideSpeed);
        outside.setAcceleration(acceleration * outsideShare);
        inside.setAcceleration(acceleration * insideShare);
    }
}
