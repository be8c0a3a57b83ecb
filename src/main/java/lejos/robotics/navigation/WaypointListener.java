package lejos.robotics.navigation;

/** Told about waypoints as they are found. */
public interface WaypointListener {
    /** The next waypoint. */
    void addWaypoint(Waypoint wp);

    /** The path is complete. */
    void pathGenerated();
}
