package lejos.robotics.navigation;

/** Told how a robot gets on along its path. */
public interface NavigationListener {
    /** The robot has reached a waypoint, the sequence-th of the path (from 1). */
    void atWaypoint(Waypoint waypoint, Pose pose, int sequence);

    /** The robot has reached the last waypoint of the path. */
    void pathComplete(Waypoint waypoint, Pose pose, int sequence);

    /** The robot was stopped on its way to a waypoint, which is null if there was none. */
    void pathInterrupted(Waypoint waypoint, Pose pose, int sequence);
}
