package lejos.robotics.pathfinding;

/** A node of a square grid. All grids of a program share one spacing: that of the node made last. */
public class GridNode extends Node {
    private static float gridSpacing;

    /** A node of a grid with a spacing. */
    public GridNode(float x, float y, float gridSpace) {
        super(x, y);
        gridSpacing = gridSpace;
    }

    /** Cost of the way to a neighbour: the spacing. */
    @Override
    protected float calculateG(Node neighbor) {
        return gridSpacing;
    }

    /** Estimated cost from here to the goal: the distance along the grid. */
    @Override
    protected float calculateH(Node goal) {
        return Math.abs(goal.x - x) + Math.abs(goal.y - y);
    }
}
