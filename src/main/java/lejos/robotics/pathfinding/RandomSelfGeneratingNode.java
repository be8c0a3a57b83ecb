package lejos.robotics.pathfinding;

import java.util.Collection;
import java.util.Random;

/** A node that makes up its neighbours at random when first asked for them. There is no map: nothing is in the way. */
public class RandomSelfGeneratingNode extends Node {
    /** Chance; tests of this package choose its seed. */
    static final Random RANDOM = new Random();

    private static Node goal;

    private final float maxDistance;
    private final int connections;
    private boolean generated;

    /**
     * A node of the search for the goal given last.
     *
     * @param maxDist greatest distance of a neighbour along each axis
     * @param connections number of neighbours to have
     */
    public RandomSelfGeneratingNode(float x, float y, float maxDist, int connections) {
        super(x, y);
        this.maxDistance = maxDist;
        this.connections = connections;
    }

    /** A node, with the goal for it and all others. */
    public RandomSelfGeneratingNode(float x, float y, float maxDist, int connections, Node goal) {
        this(x, y, maxDist, connections);
        RandomSelfGeneratingNode.goal = goal;
    }

    /** The neighbours; made up when first asked for. The goal is among them if it is near enough. */
    @Override
    public Collection<Node> getNeighbors() {
        if (!generated) {
            generated = true;
            if (calculateG(goal) <= maxDistance) {
                link(goal);
            }
            for (int missing = connections - neighbors(); missing > 0; missing--) {
                link(new RandomSelfGeneratingNode(x + offset(), y + offset(), maxDistance, connections));
            }
        }
        return super.getNeighbors();
    }

    private void link(Node node) {
        addNeighbor(node);
        node.addNeighbor(this);
    }

    private float offset() {
        float distance = RANDOM.nextFloat() * maxDistance;
        return RANDOM.nextBoolean() ? -distance : distance;
    }
}
