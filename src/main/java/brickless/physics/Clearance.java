package brickless.physics;

import org.jbox2d.common.Sweep;

/**
 * How far a robot can still move to each side, at least, before a shape of it leaves its box in the broad phase;
 * decimetres.
 */
final class Clearance {
    /** More than any rounding error of a corner's place. */
    private static final float SAFETY = 0.005f;

    private boolean known;
    private float x;
    private float y;
    private float angle;
    private float left;
    private float top;
    private float right;
    private float bottom;
    /** Distance of the farthest point of the robot from its centre of mass; negative if unknown. */
    private float radius = -1;

    float radius() {
        return radius;
    }

    void setRadius(float newRadius) {
        radius = newRadius;
    }

    /** Whether all shapes are certainly within their boxes, with the robot where it is now. */
    boolean enough(Sweep now) {
        float dx = now.c.x - x;
        float dy = now.c.y - y;
        float turn = Math.abs(now.a - angle) * radius;
        return known && turn + dx < right && turn - dx < left && turn + dy < bottom && turn - dy < top;
    }

    /** The boxes are looked at, with the robot where it is now; {@link #limit} follows for each. */
    void begin(Sweep now) {
        known = true;
        x = now.c.x;
        y = now.c.y;
        angle = now.a;
        left = Float.POSITIVE_INFINITY;
        top = left;
        right = left;
        bottom = left;
    }

    /** So much room has one shape on each side. */
    void limit(float newLeft, float newTop, float newRight, float newBottom) {
        left = Math.min(left, newLeft - SAFETY);
        top = Math.min(top, newTop - SAFETY);
        right = Math.min(right, newRight - SAFETY);
        bottom = Math.min(bottom, newBottom - SAFETY);
    }

    /** The robot was moved by hand, or has got another shape. */
    void forget() {
        known = false;
        radius = -1;
    }
}
