package brickless.trace;

import brickless.world.Pose2;

/** A movable obstacle at one instant: {@code displacement} are the arguments of the SVG transform
 * {@code translate(x y) rotate(heading)} that puts the drawn shape where it is now. */
public record BodySample(String id, Pose2 displacement) {}
