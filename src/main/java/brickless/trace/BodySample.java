package brickless.trace;

import brickless.world.Pose2;

/** A movable obstacle at one instant: {@code pose} is its displacement from the drawn place, about its centroid. */
public record BodySample(String id, Pose2 pose) {}
