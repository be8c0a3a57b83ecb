package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.List;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** The listeners of a path finder. */
final class WaypointListeners {
    private final List<WaypointListener> listeners = new ArrayList<>();

    void add(WaypointListener listener) {
        listeners.add(listener);
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
