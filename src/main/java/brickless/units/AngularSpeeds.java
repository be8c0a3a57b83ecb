package brickless.units;

/** Angular speeds: the project computes in rad/s; the leJOS API uses deg/s, motor data sheets use rpm. */
public final class AngularSpeeds {
    private AngularSpeeds() {}

    /** Revolutions per minute to radians per second. */
    public static double radiansPerSecondFromRpm(double rpm) {
        return rpm / 60 * Angles.FULL_TURN_RADIANS;
    }

    /** Radians per second to revolutions per minute. */
    public static double rpmFromRadiansPerSecond(double radiansPerSecond) {
        return radiansPerSecond / Angles.FULL_TURN_RADIANS * 60;
    }

    /** Revolutions per minute to degrees per second. */
    public static double degreesPerSecondFromRpm(double rpm) {
        return rpm * 6;
    }

    /** Degrees per second to revolutions per minute. */
    public static double rpmFromDegreesPerSecond(double degreesPerSecond) {
        return degreesPerSecond / 6;
    }

    /** Degrees per second to radians per second. */
    public static double radiansPerSecondFromDegreesPerSecond(double degreesPerSecond) {
        return Angles.radiansFromDegrees(degreesPerSecond);
    }

    /** Radians per second to degrees per second. */
    public static double degreesPerSecondFromRadiansPerSecond(double radiansPerSecond) {
        return Angles.degreesFromRadians(radiansPerSecond);
    }
}
