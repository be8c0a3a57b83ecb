package brickless.physics;

/** A body that can be hit: a robot or an obstacle. */
public sealed interface Solid permits RobotBody, ObstacleBody {
    /** Name of the robot or id of the obstacle. */
    String name();
}
