package brickless.physics;

/** How far a robot can still move, at least, before a shape of it leaves its box in the broad phase; decimetres. */
final class Clearance {
    private float left;
    private float radius;

    /** Distance of the farthest point of the robot from its centre of mass. */
    float radius() {
        return radius;
    }

    /** Takes a movement into account; true if a shape may have left its box. */
    boolean usedUp(float movement) {
        left -= movement;
        return !(left > 0);
    }

    /** The boxes were looked at. */
    void renew(float newLeft, float newRadius) {
        left = newLeft;
        radius = newRadius;
    }

    /** The robot was moved by hand, or has got another shape. */
    void forget() {
        left = 0;
    }
}
