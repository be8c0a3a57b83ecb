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
 * Finds the shortest path around the walls of a map, which turns only at the ends of walls.
 *
 * <p>A search of least cost over a graph that is made as it goes: a straight way is tried, and only if a wall blocks it
 * do the ends of that wall become places to go to. Since a path may touch the ends of walls, it also slips through
 * where two walls meet; {@link #lengthenLines} keeps a robot of some width away from them. Headings are ignored.
 */
public class ShortestPathFinder implements PathFinder {
    private final WaypointListeners listeners = new WaypointListeners();
    private ArrayList<Line> map = new ArrayList<>();
    private ArrayList<Node> reached = new ArrayList<>();
    private ArrayList<Node> candidates = new ArrayList<>();
    private int iterations;
    private boolean debug;

    /** A finder for the walls of a map; prints its name. */
    public ShortestPathFinder(LineMap map) {
        System.out.println("ShortestPathFinder");
        setMap(map);
    }

    /** The shortest path, which begins at the start. */
    @Override
    public Path findRoute(Pose start, Waypoint finish) throws DestinationUnreachableException {
        Node destination = new Node(finish);
        Node source = new Node(start.getLocation());
        reached = new ArrayList<>();
        candidates = new ArrayList<>();
        reached.add(source);
        candidates.add(destination);
        while (candidates.contains(destination)) {
            iterations++;
            advance();
        }
        return routeTo(destination);
    }

    /** As {@link #findRoute(Pose, Waypoint)}, after adding the walls of another map. */
    public Path findRoute(Pose start, Waypoint finish, LineMap theMap) throws DestinationUnreachableException {
        setMap(theMap);
        return findRoute(start, finish);
    }

    /** Tries the cheapest straight way from a place reached to a candidate that is not known to be blocked. */
    private void advance() throws DestinationUnreachableException {
        Node from = null;
        Node to = null;
        float least = Float.POSITIVE_INFINITY;
        for (Node place : reached) {
            for (Node candidate : candidates) {
                float cost = place.cost + place.distanceTo(candidate);
                if (cost < least && !place.isBlocked(candidate)) {
                    least = cost;
                    from = place;
                    to = candidate;
                }
            }
        }
        if (from == null) {
            throw new DestinationUnreachableException();
        }
        attempt(from, to, least);
    }

    private void attempt(Node from, Node to, float cost) {
        Line wall = blockingLine(from, to);
        if (debug) {
            System.out.println(from + " to " + to + (wall == null ? " free" : " blocked"));
        }
        if (wall == null) {
            to.cost = cost;
            to.predecessor = from;
            candidates.remove(to);
            reached.add(to);
        } else {
            from._blocked.add(to);
            to._blocked.add(from);
            addCandidate(new Node(wall.getP1()));
            addCandidate(new Node(wall.getP2()));
        }
    }

    private void addCandidate(Node node) {
        if (!inCandidateSet(node) && reached.stream().noneMatch(node::equals)) {
            candidates.add(node);
        }
    }

    /**
     * The first wall that the way meets, unless the way begins or ends at an end of the wall; null if there is none.
     */
    private Line blockingLine(Node from, Node to) {
        Line way = new Line(from.location.x, from.location.y, to.location.x, to.location.y);
        for (Line wall : map) {
            if (!from.isEndOf(wall) && !to.isEndOf(wall) && wall.intersectsAt(way) != null) {
                return wall;
            }
        }
        return null;
    }

    private static Path routeTo(Node destination) {
        Path path = new Path();
        for (Node node = destination; node != null; node = node.predecessor) {
            path.add(0, new Waypoint(node.location));
        }
        return path;
    }

    /** Whether a place waits to be reached. */
    public boolean inCandidateSet(Node aNode) {
        return candidates.stream().anyMatch(aNode::equals);
    }

    /** Replaces the walls; not copied. */
    public void setMap(ArrayList<Line> theMap) {
        map = theMap;
    }

    /** Adds the walls of a map. */
    public void setMap(LineMap theMap) {
        map.addAll(Arrays.asList(theMap.getLines()));
    }

    /** Turns the printing of what the search does on or off. */
    public void setDebug(boolean yes) {
        debug = yes;
    }

    /** Makes every wall longer at both ends, in the map itself: call it once. */
    public void lengthenLines(float delta) {
        map.forEach(line -> line.lengthen(delta));
    }

    /** The walls: the finder's own list. */
    public ArrayList<Line> getMap() {
        return map;
    }

    /** Ways tried in all searches so far. */
    public int getIterationCount() {
        return iterations;
    }

    /** Places reached in the last search. */
    public int getNodeCount() {
        return reached.size();
    }

    @Override
    public void addListener(WaypointListener wl) {
        listeners.add(wl);
    }

    /** Finds a path and tells the listeners; prints a line if there is none. */
    @Override
    public void startPathFinding(Pose start, Waypoint end) {
        try {
            listeners.tell(findRoute(start, end));
        } catch (DestinationUnreachableException e) {
            System.out.println("Destination " + end + " not reachable");
        }
    }

    /** A place that the search has reached or may reach. */
    public class Node {
        /** Places that a wall hides from here. */
        public ArrayList<Node> _blocked = new ArrayList<>();

        private final Point location;
        private float cost;
        private Node predecessor;

        /** A place. */
        public Node(Point p) {
            location = p;
        }

        /** Whether the other is the same place. */
        public boolean equals(Node n) {
            return location.equals(n.location);
        }

        /** Whether a wall is known to hide the other place from here. */
        public boolean isBlocked(Node aNode) {
            return _blocked.contains(aNode);
        }

        @Override
        public String toString() {
            return " " + location.x + " , " + location.y + " ";
        }

        private float distanceTo(Node other) {
            return (float) location.distance(other.location);
        }

        private boolean isEndOf(Line wall) {
            return location.equals(wall.getP1()) || location.equals(wall.getP2());
        }
    }
}
