package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.Arrays;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/**
 * Finds a short path around the walls of a map, which turns only at the ends of walls: Dijkstra's algorithm on a graph
 * made as it goes.
 *
 * <p>Does what {@link ShortestPathFinder} does, with steps that a subclass can change. Of paths of equal length the two
 * may find different ones. Headings are ignored.
 */
public class DijkstraPathFinder implements PathFinder {
    /** Places nearer to each other than this are one. */
    private static final float SAME_PLACE = 0.05f;

    /** Ways tried in all searches so far. */
    protected int _count;
    /** Whether a wall blocked the way tried last. */
    protected boolean _blocked;
    /** Places that may be reached. */
    protected ArrayList<Node> _candidate = new ArrayList<>();
    /** Places reached. */
    protected ArrayList<Node> _reached = new ArrayList<>();
    /** The walls. */
    protected ArrayList<Line> _map = new ArrayList<>();

    private final WaypointListeners listeners = new WaypointListeners();

    /** A finder for the walls of a map. */
    public DijkstraPathFinder(LineMap map) {
        setMap(map);
    }

    /** A short path, which begins at the start. */
    @Override
    public Path findRoute(Pose start, Waypoint finish) throws DestinationUnreachableException {
        initialize();
        Node source = new Node(start.getLocation());
        source.setSourceDistance(0);
        Node destination = new Node(finish);
        _reached.add(source);
        _candidate.add(destination);
        while (_candidate.contains(destination)) {
            _count++;
            attempt(cheapestCandidate());
        }
        return getRoute(destination);
    }

    /** As {@link #findRoute(Pose, Waypoint)}, after adding the walls of another map. */
    public Path findRoute(Pose start, Waypoint finish, LineMap theMap) throws DestinationUnreachableException {
        setMap(theMap);
        return findRoute(start, finish);
    }

    /** Replaces the walls; not copied. */
    public void setMap(ArrayList<Line> theMap) {
        _map = theMap;
    }

    /** Adds the walls of a map. */
    public void setMap(LineMap theMap) {
        _map.addAll(Arrays.asList(theMap.getLines()));
    }

    /** Makes every wall longer at both ends, in the map itself: call it once. */
    public void lengthenLines(float delta) {
        _map.forEach(line -> line.lengthen(delta));
    }

    /** Forgets the last search. */
    protected void initialize() {
        _reached = new ArrayList<>();
        _candidate = new ArrayList<>();
        _blocked = false;
    }

    /** Whether a wall blocks the way; if so, its ends become candidates. Of several walls it is the last of the map. */
    protected boolean segmentBlocked(Node from, Node theDest) {
        Line way = new Line(from.getX(), from.getY(), theDest.getX(), theDest.getY());
        Line blocking = null;
        for (Line wall : _map) {
            if (!from.atEndOfLine(wall) && !theDest.atEndOfLine(wall) && wall.intersectsAt(way) != null) {
                blocking = wall;
            }
        }
        _blocked = blocking != null;
        if (_blocked) {
            from.block(theDest);
            theDest.block(from);
            addCandidate(new Node(blocking.getP2()));
            addCandidate(new Node(blocking.getP1()));
        }
        return _blocked;
    }

    /**
     * The place reached from which the way by it to a candidate is shortest and not known to be blocked; null if there
     * is none.
     */
    protected Node getBest(Node currentDestination) {
        Node best = null;
        float least = Float.POSITIVE_INFINITY;
        for (Node node : _reached) {
            float distance = node.getSourceDistance() + node.getDistance(currentDestination);
            if (distance < least && !node._blocked.contains(currentDestination)) {
                least = distance;
                best = node;
            }
        }
        return best;
    }

    /** Whether a place has been reached. */
    protected boolean inReachedSet(Node aNode) {
        return _reached.stream().anyMatch(node -> node.getDistance(aNode) < SAME_PLACE);
    }

    /** Whether a place waits to be reached. */
    protected boolean inCandidateSet(Node aNode) {
        return _candidate.stream().anyMatch(node -> node.getDistance(aNode) < SAME_PLACE);
    }

    /** The path from the start to a place reached. */
    protected Path getRoute(Node destination) {
        Path route = new Path();
        for (Node node = destination; node != null; node = node.getPredecessor()) {
            route.add(0, new Waypoint(node.getLocation()));
        }
        return route;
    }

    /** The walls: the finder's own list. */
    protected ArrayList<Line> getMap() {
        return _map;
    }

    /** Ways tried in all searches so far. */
    public int getIterationCount() {
        return _count;
    }

    /** Places reached in the last search. */
    public int getNodeCount() {
        return _reached.size();
    }

    @Override
    public void addListener(WaypointListener wl) {
        listeners.add(wl);
    }

    /** Finds a path and tells the listeners; prints a line if there is none. */
    @Override
    public void startPathFinding(Pose start, Waypoint end) {
        listeners.tellOrPrint(this, start, end);
    }

    private Node cheapestCandidate() throws DestinationUnreachableException {
        Node cheapest = null;
        float least = Float.POSITIVE_INFINITY;
        for (Node candidate : _candidate) {
            Node from = getBest(candidate);
            if (from != null && from.getSourceDistance() + from.getDistance(candidate) < least) {
                least = from.getSourceDistance() + from.getDistance(candidate);
                cheapest = candidate;
            }
        }
        if (cheapest == null) {
            throw new DestinationUnreachableException();
        }
        return cheapest;
    }

    private void attempt(Node candidate) {
        Node from = getBest(candidate);
        if (!segmentBlocked(from, candidate)) {
            candidate.setPredecessor(from);
            candidate.setSourceDistance(from.getSourceDistance() + from.getDistance(candidate));
            _candidate.remove(candidate);
            _reached.add(candidate);
        }
    }

    private void addCandidate(Node node) {
        if (!inCandidateSet(node) && !inReachedSet(node)) {
            _candidate.add(node);
        }
    }

    /** A place that the search has reached or may reach. */
    protected class Node {
        /** Where. */
        protected Point _p;
        /** Length of the way from the start. */
        protected float _sourceDistance;
        /** The place before this one on the way from the start. */
        protected Node _predecessor;
        /** Places that a wall hides from here. */
        public ArrayList<Node> _blocked = new ArrayList<>();

        /** A place. */
        public Node(Point p) {
            _p = p;
        }

        /** A place. */
        public Node(float x, float y) {
            this(new Point(x, y));
        }

        /** Whether a wall ends here. */
        public boolean atEndOfLine(Line line) {
            return _p.equals(line.getP1()) || _p.equals(line.getP2());
        }

        /** Sets the length of the way from the start. */
        public void setSourceDistance(float theDistance) {
            _sourceDistance = theDistance;
        }

        /** Length of the way from the start. */
        public float getSourceDistance() {
            return _sourceDistance;
        }

        /** Distance to a point. */
        public float getDistance(Point p) {
            return (float) _p.distance(p);
        }

        /** Distance to a place. */
        public float getDistance(Node aNode) {
            return getDistance(aNode._p);
        }

        /** Where. */
        public Point getLocation() {
            return _p;
        }

        /** Notes that a wall hides the other place from here. */
        public void block(Node aNode) {
            _blocked.add(aNode);
        }

        /** Sets the place before this one on the way from the start. */
        public void setPredecessor(Node aNode) {
            _predecessor = aNode;
        }

        /** The place before this one on the way from the start. */
        public Node getPredecessor() {
            return _predecessor;
        }

        /** The x coordinate. */
        public float getX() {
            return _p.x;
        }

        /** The y coordinate. */
        public float getY() {
            return _p.y;
        }

        @Override
        public String toString() {
            return " " + getX() + " , " + getY() + " ";
        }
    }
}
