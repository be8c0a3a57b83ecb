package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.Collection;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;

/** A square grid over a map; nodes are linked to their neighbours along x and y where no wall is near. */
public class FourWayGridMesh implements NavigationMesh {
    private LineMap map;
    private float gridSpacing;
    private float clearance;
    private ArrayList<Node> mesh;

    /**
     * A grid, made when first needed.
     *
     * @param map the walls
     * @param gridSpace distance of neighbours
     * @param clearance least distance of links from walls
     */
    public FourWayGridMesh(LineMap map, float gridSpace, float clearance) {
        this.map = map;
        this.gridSpacing = gridSpace;
        this.clearance = clearance;
    }

    /** All nodes, row by row: the grid's own list. */
    @Override
    public Collection<Node> getMesh() {
        if (mesh == null) {
            regenerate();
        }
        return mesh;
    }

    /** Sets the distance of neighbours, for {@link #regenerate}. */
    public void setGridSpacing(float gridSpace) {
        this.gridSpacing = gridSpace;
    }

    /** Sets the least distance of links from walls, for new links. */
    public void setClearance(float clearance) {
        this.clearance = clearance;
    }

    /** Sets the map, for new links and {@link #regenerate}. */
    public void setMap(LineMap map) {
        this.map = map;
    }

    @Override
    public void regenerate() {
        mesh = new ArrayList<>();
        Rectangle area = map.getBoundingRect();
        ArrayList<Node> below = new ArrayList<>();
        for (float y = area.y + clearance; y < area.y + area.height - clearance; y += gridSpacing) {
            ArrayList<Node> row = new ArrayList<>();
            for (float x = area.x + clearance; x < area.x + area.width - clearance; x += gridSpacing) {
                row.add(new GridNode(x, y, gridSpacing));
            }
            link(row, below);
            mesh.addAll(row);
            below = row;
        }
    }

    @Override
    public boolean connect(Node node1, Node node2) {
        if (!isFree(node1, node2)) {
            return false;
        }
        node1.addNeighbor(node2);
        node2.addNeighbor(node1);
        return true;
    }

    /** Removes the link of two nodes; always true. */
    @Override
    public boolean disconnect(Node node1, Node node2) {
        node1.removeNeighbor(node2);
        node2.removeNeighbor(node1);
        return true;
    }

    /**
     * Adds a node and links it to the first of those not farther than the spacing along each axis; returns how many.
     */
    @Override
    public int addNode(Node node, int neighbors) {
        int links = 0;
        for (Node other : getMesh()) {
            if (links == neighbors) {
                break;
            }
            boolean near = Math.abs(other.x - node.x) <= gridSpacing && Math.abs(other.y - node.y) <= gridSpacing;
            if (near && connect(node, other)) {
                links++;
            }
        }
        mesh.add(node);
        return links;
    }

    @Override
    public boolean removeNode(Node node) {
        for (Node neighbor : new ArrayList<>(node.getNeighbors())) {
            disconnect(node, neighbor);
        }
        return getMesh().remove(node);
    }

    private void link(ArrayList<Node> row, ArrayList<Node> below) {
        for (int i = 0; i < row.size(); i++) {
            if (!below.isEmpty()) {
                connect(below.get(i), row.get(i));
            }
            if (i > 0) {
                connect(row.get(i - 1), row.get(i));
            }
        }
    }

    private boolean isFree(Node node1, Node node2) {
        Rectangle area = map.getBoundingRect();
        if (!area.contains(node1.x, node1.y) || !area.contains(node2.x, node2.y)) {
            return false;
        }
        Line way = new Line(node1.x, node1.y, node2.x, node2.y);
        for (Line wall : map.getLines()) {
            if (wall.segDist(way) < clearance) {
                return false;
            }
        }
        return true;
    }
}
