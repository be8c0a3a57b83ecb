package brickless.world;

/** Position in metres and heading in radians, clockwise on the page from +x. */
public record Pose2(double x, double y, double headingRadians) {}
