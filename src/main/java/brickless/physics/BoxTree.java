package brickless.physics;

import java.util.Arrays;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.broadphase.BroadPhaseStrategy;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * A balanced tree of bounding boxes with the same numbers, boxes and order as JBox2D's {@code DynamicTree}
 * (BoxTreeTest), kept in arrays: a search reads one piece of memory for each node, where JBox2D follows four
 * references.
 *
 * <p>A new leaf goes where the sum of all perimeters grows least; nodes on the way up are rotated if one side is higher
 * by more than one.
 */
final class BoxTree implements BroadPhaseStrategy {
    private static final int NONE = -1;
    private static final int FEW = 16;

    private int root = NONE;
    private int used;
    private int freed;
    private int insertions;
    /** Left, top, right, bottom of each node, decimetres. */
    private float[] boxes = new float[4 * FEW];
    private int[] parent = new int[FEW];
    private int[] first = new int[FEW];
    private int[] second = new int[FEW];
    private int[] height = new int[FEW];
    private int[] free = new int[FEW];
    private AABB[] fat = new AABB[FEW];
    private Object[] userData = new Object[FEW];
    private int[] stack = new int[FEW];

    @Override
    public int createProxy(AABB box, Object data) {
        int leaf = allocate();
        userData[leaf] = data;
        fat[leaf] = new AABB();
        setBox(leaf, box, 0, 0);
        insert(leaf);
        return leaf;
    }

    @Override
    public void destroyProxy(int proxy) {
        remove(proxy);
        userData[proxy] = null;
        fat[proxy] = null;
        free[freed++] = proxy;
    }

    @Override
    public boolean moveProxy(int proxy, AABB box, Vec2 displacement) {
        remove(proxy);
        setBox(proxy, box, displacement.x * Settings.aabbMultiplier, displacement.y * Settings.aabbMultiplier);
        insert(proxy);
        return true;
    }

    /** Gives a leaf its box: with a margin all around, and more in the direction of its movement. */
    private void setBox(int leaf, AABB box, float aheadX, float aheadY) {
        AABB wide = fat[leaf];
        wide.lowerBound.x = box.lowerBound.x - Settings.aabbExtension;
        wide.lowerBound.y = box.lowerBound.y - Settings.aabbExtension;
        wide.upperBound.x = box.upperBound.x + Settings.aabbExtension;
        wide.upperBound.y = box.upperBound.y + Settings.aabbExtension;
        if (aheadX < 0) {
            wide.lowerBound.x += aheadX;
        } else {
            wide.upperBound.x += aheadX;
        }
        if (aheadY < 0) {
            wide.lowerBound.y += aheadY;
        } else {
            wide.upperBound.y += aheadY;
        }
        boxes[4 * leaf] = wide.lowerBound.x;
        boxes[4 * leaf + 1] = wide.lowerBound.y;
        boxes[4 * leaf + 2] = wide.upperBound.x;
        boxes[4 * leaf + 3] = wide.upperBound.y;
    }

    private int allocate() {
        int node = freed > 0 ? free[--freed] : used++;
        if (node == parent.length) {
            int size = 2 * node;
            boxes = Arrays.copyOf(boxes, 4 * size);
            parent = Arrays.copyOf(parent, size);
            first = Arrays.copyOf(first, size);
            second = Arrays.copyOf(second, size);
            height = Arrays.copyOf(height, size);
            free = Arrays.copyOf(free, size);
            fat = Arrays.copyOf(fat, size);
            userData = Arrays.copyOf(userData, size);
            stack = new int[size];
        }
        parent[node] = NONE;
        first[node] = NONE;
        second[node] = NONE;
        height[node] = 0;
        return node;
    }

    private void insert(int leaf) {
        insertions++;
        if (root == NONE) {
            root = leaf;
            parent[leaf] = NONE;
            return;
        }
        int sibling = bestSibling(leaf);
        int above = parent[sibling];
        int joint = allocate();
        parent[joint] = above;
        combine(joint, leaf, sibling);
        height[joint] = height[sibling] + 1;
        replaceChild(above, sibling, joint);
        first[joint] = sibling;
        second[joint] = leaf;
        parent[sibling] = joint;
        parent[leaf] = joint;
        refit(joint);
    }

    /** The node beside which a leaf makes the perimeters grow least. */
    private int bestSibling(int leaf) {
        int node = root;
        while (first[node] != NONE) {
            float around = perimeter(node, leaf);
            float alone = 2.0f * around;
            float inherited = 2.0f * (around - perimeter(node, node));
            float cost1 = descent(first[node], leaf, inherited);
            float cost2 = descent(second[node], leaf, inherited);
            if (alone < cost1 && alone < cost2) {
                break;
            }
            node = cost1 < cost2 ? first[node] : second[node];
        }
        return node;
    }

    private float descent(int child, int leaf, float inherited) {
        float around = perimeter(leaf, child);
        return first[child] == NONE ? around + inherited : around - perimeter(child, child) + inherited;
    }

    /** Perimeter of the box around two nodes. */
    private float perimeter(int a, int b) {
        int i = 4 * a;
        int k = 4 * b;
        float width = Math.max(boxes[i + 2], boxes[k + 2]) - Math.min(boxes[i], boxes[k]);
        return 2.0f * (width + Math.max(boxes[i + 3], boxes[k + 3]) - Math.min(boxes[i + 1], boxes[k + 1]));
    }

    private void combine(int node, int a, int b) {
        int to = 4 * node;
        int i = 4 * a;
        int k = 4 * b;
        boxes[to] = Math.min(boxes[i], boxes[k]);
        boxes[to + 1] = Math.min(boxes[i + 1], boxes[k + 1]);
        boxes[to + 2] = Math.max(boxes[i + 2], boxes[k + 2]);
        boxes[to + 3] = Math.max(boxes[i + 3], boxes[k + 3]);
    }

    /** Puts a node in the place of a child, or of the root if there is no parent. */
    private void replaceChild(int above, int child, int by) {
        if (above == NONE) {
            root = by;
        } else if (first[above] == child) {
            first[above] = by;
        } else {
            second[above] = by;
        }
    }

    private void remove(int leaf) {
        if (leaf == root) {
            root = NONE;
            return;
        }
        int joint = parent[leaf];
        int sibling = first[joint] == leaf ? second[joint] : first[joint];
        int above = parent[joint];
        replaceChild(above, joint, sibling);
        parent[sibling] = above;
        free[freed++] = joint;
        refit(above);
    }

    /** Balances and measures a node and all above it. */
    private void refit(int from) {
        for (int node = from; node != NONE; node = parent[node]) {
            node = balance(node);
            measure(node, first[node], second[node]);
        }
    }

    private void measure(int node, int a, int b) {
        height[node] = 1 + Math.max(height[a], height[b]);
        combine(node, a, b);
    }

    /** Rotates a node if one side is too high; returns what stands in its place. */
    private int balance(int node) {
        if (height[node] < 2) {
            return node;
        }
        int tilt = height[second[node]] - height[first[node]];
        if (tilt > 1) {
            return raise(node, second[node], first[node]);
        }
        return tilt < -1 ? raise(node, first[node], second[node]) : node;
    }

    /** Puts the higher child in the place of its parent, which takes over the lower grandchild. */
    private int raise(int node, int child, int other) {
        boolean right = second[node] == child;
        int a = first[child];
        int b = second[child];
        replaceChild(parent[node], node, child);
        parent[child] = parent[node];
        parent[node] = child;
        first[child] = node;
        int high = height[a] > height[b] ? a : b;
        int low = high == a ? b : a;
        second[child] = high;
        if (right) {
            second[node] = low;
        } else {
            first[node] = low;
        }
        parent[low] = node;
        measure(node, other, low);
        measure(child, node, high);
        return child;
    }

    @Override
    public Object getUserData(int proxy) {
        return userData[proxy];
    }

    @Override
    public AABB getFatAABB(int proxy) {
        return fat[proxy];
    }

    @Override
    public void query(TreeCallback callback, AABB box) {
        float left = box.lowerBound.x;
        float top = box.lowerBound.y;
        float right = box.upperBound.x;
        float bottom = box.upperBound.y;
        int depth = 0;
        if (root != NONE) {
            stack[depth++] = root;
        }
        while (depth > 0) {
            int node = stack[--depth];
            int i = 4 * node;
            if (boxes[i] > right || boxes[i + 1] > bottom || boxes[i + 2] < left || boxes[i + 3] < top) {
                continue;
            }
            if (first[node] != NONE) {
                stack[depth++] = first[node];
                stack[depth++] = second[node];
            } else if (!callback.treeCallback(node)) {
                return;
            }
        }
    }

    @Override
    public void raycast(TreeRayCastCallback callback, RayCastInput ray) {
        AABB around = new AABB();
        Vec2.minToOut(ray.p1, ray.p2, around.lowerBound);
        Vec2.maxToOut(ray.p1, ray.p2, around.upperBound);
        RayCastInput rest = new RayCastInput();
        rest.set(ray);
        query(proxy -> {
            float fraction = callback.raycastCallback(rest, proxy);
            if (fraction > 0) {
                rest.maxFraction = fraction;
            }
            return fraction != 0;
        }, around);
    }

    @Override
    public int computeHeight() {
        return getHeight();
    }

    @Override
    public int getHeight() {
        return root == NONE ? 0 : height[root];
    }

    @Override
    public int getMaxBalance() {
        return maxBalance(root);
    }

    private int maxBalance(int node) {
        if (node == NONE || first[node] == NONE) {
            return 0;
        }
        int tilt = Math.abs(height[first[node]] - height[second[node]]);
        return Math.max(tilt, Math.max(maxBalance(first[node]), maxBalance(second[node])));
    }

    @Override
    public float getAreaRatio() {
        return root == NONE ? 0 : perimeters(root) / perimeter(root, root);
    }

    private float perimeters(int node) {
        return perimeter(node, node) + (first[node] == NONE ? 0 : perimeters(first[node]) + perimeters(second[node]));
    }

    @Override
    public int getInsertionCount() {
        return insertions;
    }

    @Override
    public void drawTree(DebugDraw draw) {
        throw new UnsupportedOperationException("nobody looks at the boxes");
    }
}
