package brickless.physics;

/** Where a sensor is and where it looks, in the arena's frame. Mutable so that reading it allocates nothing. */
public final class Aim {
    /** Metres. */
    public double x;
    /** Metres. */
    public double y;
    /** Radians, clockwise on the page from +x. */
    public double headingRadians;
}
