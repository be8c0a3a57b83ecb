package brickless.physics;

/** Sine and cosine of a body's angle, computed once for every angle: a robot that drives turns, solves, and looks with the same ones. */
final class Rotation {
    private float angle = Float.NaN;
    private final SineCosine trigonometry = new SineCosine();

    /** Makes this the rotation by an angle in radians. */
    Rotation to(float radians) {
        if (radians != angle) {
            angle = radians;
            trigonometry.of(radians);
        }
        return this;
    }

    double cos() {
        return trigonometry.cos();
    }

    double sin() {
        return trigonometry.sin();
    }
}
