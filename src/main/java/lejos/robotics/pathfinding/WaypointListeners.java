package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.List;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** The listeners of a path finder. */
final class WaypointListeners {
    private final List<WaypointListener> listeners = new ArrayList<>();

    void add(WaypointListener listener) {
        listeners.add(listener);
    }

    /** Finds a path and tells it; prints a line if there is none. */
    void tellOrPrint(PathFinder finder, Pose start, Waypoint end) {
        try {
            tell(finder.findRoute(start, end));
        } catch (DestinationUnreachableException e) {
            System.out.println("Destination " + end + " not reachable");
        }
    }

    /** Tells each listener the whole path. */
    void tell(Path path) {
        for (WaypointListener listener : listeners) {
            for (Waypoint waypoint : path) {
                listener.addWaypoint(waypoint);
            }
            listener.pathGenerated();
        }
    }
}
