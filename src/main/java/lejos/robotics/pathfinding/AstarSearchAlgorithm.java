package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.List;
import lejos.robotics.navigation.Waypoint;

/**
 * The A* algorithm of Hart, Nilsson and Raphael: always looks on from the node where cost so far plus estimate is
 * least.
 *
 * <p>Scores are kept in the nodes, so only one search may run on a mesh at a time.
 */
public class AstarSearchAlgorithm implements SearchAlgorithm {
    /** A search. */
    public AstarSearchAlgorithm() {
    }

    @Override
    public Path findPath(Node start, Node goal) {
        List<Node> open = new ArrayList<>();
        List<Node> closed = new ArrayList<>();
        start.setG_Score(0);
        start.setH_Score(start.calculateH(goal));
        start.setPredecessor(null);
        open.add(start);
        while (!open.isEmpty()) {
            Node node = cheapest(open);
            if (node == goal) {
                return pathTo(goal);
            }
            open.remove(node);
            closed.add(node);
            for (Node neighbor : new ArrayList<>(node.getNeighbors())) {
                if (!closed.contains(neighbor)) {
                    reach(neighbor, node, goal, open);
                }
            }
        }
        return null;
    }

    @Override
    public String toString() {
        return "A*";
    }

    /** Notes the way to a node by another one, if it is the first or a better one. */
    private static void reach(Node node, Node from, Node goal, List<Node> open) {
        float cost = from.getG_Score() + from.calculateG(node);
        boolean known = open.contains(node);
        if (known && cost >= node.getG_Score()) {
            return;
        }
        node.setG_Score(cost);
        node.setH_Score(node.calculateH(goal));
        node.setPredecessor(from);
        if (!known) {
            open.add(node);
        }
    }

    private static Node cheapest(List<Node> open) {
        Node best = open.get(0);
        for (Node node : open) {
            if (node.getF_Score() < best.getF_Score()) {
                best = node;
            }
        }
        return best;
    }

    private static Path pathTo(Node goal) {
        Path path = new Path();
        for (Node node = goal; node != null; node = node.getPredecessor()) {
            path.add(0, new Waypoint(node.x, node.y));
        }
        return path;
    }
}
