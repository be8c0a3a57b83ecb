package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.Collection;

/** A place in a mesh, with links to neighbours. Holds the scores of the one search that is in progress. */
public class Node {
    /** The x coordinate. */
    public float x;
    /** The y coordinate. */
    public float y;

    private final ArrayList<Node> neighbors = new ArrayList<>();
    private Node predecessor;
    private float cost;
    private float estimate;

    /** A node without neighbours. */
    public Node(float x, float y) {
        this.x = x;
        this.y = y;
    }

    /** The neighbours: the node's own list. */
    public Collection<Node> getNeighbors() {
        return neighbors;
    }

    /** Number of neighbours. */
    public int neighbors() {
        return neighbors.size();
    }

    /** Adds a neighbour, one way; false if it is one already or this node itself. */
    public boolean addNeighbor(Node neighbor) {
        if (neighbor == this || neighbors.contains(neighbor)) {
            return false;
        }
        return neighbors.add(neighbor);
    }

    /** Removes a neighbour, one way; false if it is none. */
    public boolean removeNeighbor(Node neighbor) {
        return neighbors.remove(neighbor);
    }

    /** Sets the estimated cost from here to the goal. */
    protected void setH_Score(float h) {
        estimate = h;
    }

    /** Cost of the way to a neighbour: the distance. */
    protected float calculateG(Node neighbor) {
        return (float) Math.sqrt((neighbor.x - x) * (neighbor.x - x) + (neighbor.y - y) * (neighbor.y - y));
    }

    /** Estimated cost from here to the goal, never more than the true one: the distance. */
    protected float calculateH(Node goal) {
        return calculateG(goal);
    }

    /** Sets the cost from the start to here. */
    protected void setG_Score(float g) {
        cost = g;
    }

    /** The cost from the start to here. */
    protected float getG_Score() {
        return cost;
    }

    /** The cost from the start to here and on to the goal, as far as known. */
    protected float getF_Score() {
        return cost + estimate;
    }

    /** The node before this one on the best way from the start. */
    protected Node getPredecessor() {
        return predecessor;
    }

    /** Sets the node before this one on the best way from the start. */
    protected void setPredecessor(Node node) {
        predecessor = node;
    }
}
