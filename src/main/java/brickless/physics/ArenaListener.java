package brickless.physics;

/** Told about what happens in the arena, inside the step in which it happens, in a fixed order. */
public interface ArenaListener {
    /** Ignores everything. */
    ArenaListener NONE = new ArenaListener() {};

    /**
     * Two bodies, at least one of them a robot, touched after having been apart for a while.
     *
     * @param hitter the one that moved into the other
     * @param hit the other
     * @param speedMetresPerSecond how fast they closed in
     */
    default void collision(Solid hitter, Solid hit, double speedMetresPerSecond) {}

    /** A robot's origin entered a zone. */
    default void zoneEntered(RobotBody robot, String zone) {}

    /** A robot's origin left a zone. */
    default void zoneLeft(RobotBody robot, String zone) {}

    /** A wheel of the robot left the table. Told once. */
    default void fell(RobotBody robot) {}
}
