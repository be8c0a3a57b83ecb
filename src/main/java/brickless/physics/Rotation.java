package brickless.physics;

/**
 * Sine and cosine of a body's angle, computed once for every angle: a robot that drives turns, solves, and looks with
 * the same ones.
 */
final class Rotation {
    private float angle = Float.NaN;
    private double cos;
    private double sin;

    /** Makes this the rotation by an angle in radians. */
    Rotation to(float radians) {
        if (radians != angle) {
            angle = radians;
            cos = StrictMath.cos(radians);
            sin = StrictMath.sin(radians);
        }
        return this;
    }

    double cos() {
        return cos;
    }

    double sin() {
        return sin;
    }
}
