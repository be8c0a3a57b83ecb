package brickless.units;

/** Angles: the project computes in radians; the leJOS API and people use degrees. */
public final class Angles {
    /** One full turn in radians. */
    public static final double FULL_TURN_RADIANS = 2 * Math.PI;

    private Angles() {}

    /** Degrees to radians. */
    public static double radiansFromDegrees(double degrees) {
        return degrees / 180 * Math.PI;
    }

    /** Radians to degrees. */
    public static double degreesFromRadians(double radians) {
        return radians / Math.PI * 180;
    }

    /** The same direction in the range above −π up to and including π. */
    public static double normalizedRadians(double radians) {
        double turned = StrictMath.IEEEremainder(radians, FULL_TURN_RADIANS);
        return turned <= -Math.PI ? turned + FULL_TURN_RADIANS : turned;
    }

    /** The same direction in the range above −180 up to and including 180. */
    public static double normalizedDegrees(double degrees) {
        double turned = StrictMath.IEEEremainder(degrees, 360);
        return turned <= -180 ? turned + 360 : turned;
    }
}
