package lejos.robotics.pathfinding;

import java.util.Collection;

/** Nodes a robot can be at, linked where it can drive straight from one to the other. */
public interface NavigationMesh {
    /** Adds a node and links it to at most so many others; returns how many. */
    int addNode(Node node, int neighbors);

    /** Removes a node and its links; false if it was not there. */
    boolean removeNode(Node node);

    /** Links two nodes; false if a robot cannot drive from one to the other. */
    boolean connect(Node node1, Node node2);

    /** Removes the link of two nodes. */
    boolean disconnect(Node node1, Node node2);

    /** All nodes. */
    Collection<Node> getMesh();

    /** Makes all nodes anew. */
    void regenerate();
}
