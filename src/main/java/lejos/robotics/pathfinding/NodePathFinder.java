package lejos.robotics.pathfinding;

import java.util.Optional;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Finds paths by a search through a mesh; headings are ignored. */
public class NodePathFinder implements PathFinder {
    private static final int NEIGHBORS = 4;

    private final WaypointListeners listeners = new WaypointListeners();
    private SearchAlgorithm algorithm;
    private NavigationMesh mesh;

    /** A finder. */
    public NodePathFinder(SearchAlgorithm alg, NavigationMesh mesh) {
        this.algorithm = alg;
        this.mesh = mesh;
    }

    /** Sets the mesh. */
    public void setNavMesh(NavigationMesh mesh) {
        this.mesh = mesh;
    }

    /** Sets the search. */
    public void setSearchAlgorithm(SearchAlgorithm alg) {
        this.algorithm = alg;
    }

    @Override
    public void addListener(WaypointListener wl) {
        listeners.add(wl);
    }

    /** A path that begins at the start; start and destination are part of the mesh only meanwhile. */
    @Override
    public Path findRoute(Pose start, Waypoint destination) throws DestinationUnreachableException {
        Node first = new Node(start.getX(), start.getY());
        Node last = new Node(destination.x, destination.y);
        return search(first, last).orElseThrow(DestinationUnreachableException::new);
    }

    private Optional<Path> search(Node first, Node last) {
        if (mesh == null) {
            return Optional.empty();
        }
        mesh.addNode(first, NEIGHBORS);
        mesh.addNode(last, NEIGHBORS);
        try {
            return Optional.ofNullable(algorithm.findPath(first, last));
        } finally {
            mesh.removeNode(first);
            mesh.removeNode(last);
        }
    }

    @Override
    public void startPathFinding(Pose start, Waypoint end) {
        Node first = new Node(start.getX(), start.getY());
        search(first, new Node(end.x, end.y)).ifPresent(listeners::tell);
    }
}
