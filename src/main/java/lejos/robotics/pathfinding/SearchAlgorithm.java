package lejos.robotics.pathfinding;

/** Finds a path through a mesh of nodes. */
public interface SearchAlgorithm {
    /** The path from one node to another, both included; null if there is none. */
    Path findPath(Node start, Node goal);
}
