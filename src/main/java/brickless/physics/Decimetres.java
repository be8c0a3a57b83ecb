package brickless.physics;

import org.jbox2d.common.Settings;

/**
 * The solver's units: decimetres, kilograms, seconds, because JBox2D is tuned for bodies of 0.1 to 10 units.
 *
 * <p>Loading this class also switches JBox2D's trigonometric tables off: without them it computes sine, cosine and arc
 * tangent with {@link StrictMath}, so that results are the same on every JDK.
 */
final class Decimetres {
    /** Decimetres in a metre. */
    static final double PER_METRE = 10;

    static {
        Settings.SINCOS_LUT_ENABLED = false;
        Settings.FAST_ATAN2 = false;
    }

    private Decimetres() {}

    /** Makes sure that the solver is set up before its first use. */
    static void use() {
        // Loading the class is all that is needed.
    }

    static float of(double metres) {
        return (float) (metres * PER_METRE);
    }

    static double metres(float decimetres) {
        return decimetres / PER_METRE;
    }

    /** Newtons to kg·dm/s². */
    static float force(double newtons) {
        return (float) (newtons * PER_METRE);
    }

    /** Newton metres to kg·dm²/s². */
    static float torque(double newtonMetres) {
        return (float) (newtonMetres * PER_METRE * PER_METRE);
    }

    /** kg·dm² to kg·m². */
    static double inertia(float kilogramSquareDecimetres) {
        return kilogramSquareDecimetres / (PER_METRE * PER_METRE);
    }

    /** kg·dm/s to N·s. */
    static double impulse(float kilogramDecimetresPerSecond) {
        return kilogramDecimetresPerSecond / PER_METRE;
    }
}
