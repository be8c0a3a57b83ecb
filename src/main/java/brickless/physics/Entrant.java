package brickless.physics;

import brickless.world.Pose2;
import brickless.world.RobotModel;

/** A robot that is to be put into an arena. */
public record Entrant(String name, RobotModel model, Pose2 start) {}
