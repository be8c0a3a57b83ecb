package brickless.world;

/** A point or vector of the drawing's plane, metres: x to the right, y down the page. */
public record Point2(double x, double y) {}
