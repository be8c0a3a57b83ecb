package lejos.robotics.pathfinding;

import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Finds paths. */
public interface PathFinder {
    /**
     * A path.
     *
     * @throws DestinationUnreachableException if none was found
     */
    Path findRoute(Pose start, Waypoint destination) throws DestinationUnreachableException;

    /** Adds a listener for {@link #startPathFinding}. */
    void addListener(WaypointListener wl);

    /**
     * Finds a path and tells the listeners its waypoints one by one, on the caller's thread; does nothing if there is
     * none.
     */
    void startPathFinding(Pose start, Waypoint end);
}
