package brickless.units;

/** Angular speeds: the project computes in rad/s; the leJOS API uses deg/s, motor data sheets use rpm. */
public final class AngularSpeeds {
    private AngularSpeeds() {}

    /** Revolutions per minute to radians per second. */
    public static double radiansPerSecondFromRpm(double rpm) {
        return rpm / 60 * Angles.FULL_TURN_RADIANS;
    }
}
