package brickless.physics;

import java.util.IdentityHashMap;
import java.util.Map;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.broadphase.BroadPhaseStrategy;
import org.jbox2d.common.Vec2;

/**
 * The tree of bounding boxes, but a shape that moves within its box with margin stays where it is in the tree.
 *
 * <p>That is what the margin is for; the tree of JBox2D 2.2.1.1 compares the boxes the wrong way round and takes every
 * moving shape out and in again at every step, which was a third of the time of a run.
 */
final class LazyTree implements BroadPhaseStrategy {
    private final BoxTree tree = new BoxTree();
    private final Map<Object, Integer> proxies = new IdentityHashMap<>();
    private int version;

    @Override
    public boolean moveProxy(int proxy, AABB box, Vec2 displacement) {
        return !contains(tree.getFatAABB(proxy), box) && tree.moveProxy(proxy, box, displacement);
    }

    static boolean contains(AABB outer, AABB inner) {
        return outer.lowerBound.x <= inner.lowerBound.x && outer.lowerBound.y <= inner.lowerBound.y
                && inner.upperBound.x <= outer.upperBound.x && inner.upperBound.y <= outer.upperBound.y;
    }

    @Override
    public int createProxy(AABB box, Object userData) {
        int proxy = tree.createProxy(box, userData);
        proxies.put(userData, proxy);
        version++;
        return proxy;
    }

    /** Changes with every new proxy. */
    int version() {
        return version;
    }

    /** Number of the proxy with this user data. */
    int proxyOf(Object userData) {
        return proxies.get(userData);
    }

    @Override
    public void destroyProxy(int proxy) {
        proxies.remove(tree.getUserData(proxy));
        tree.destroyProxy(proxy);
    }

    @Override
    public Object getUserData(int proxy) {
        return tree.getUserData(proxy);
    }

    @Override
    public AABB getFatAABB(int proxy) {
        return tree.getFatAABB(proxy);
    }

    @Override
    public void query(TreeCallback callback, AABB box) {
        tree.query(callback, box);
    }

    @Override
    public void raycast(TreeRayCastCallback callback, RayCastInput input) {
        tree.raycast(callback, input);
    }

    @Override
    public int computeHeight() {
        return tree.computeHeight();
    }

    @Override
    public int getHeight() {
        return tree.getHeight();
    }

    @Override
    public int getMaxBalance() {
        return tree.getMaxBalance();
    }

    @Override
    public float getAreaRatio() {
        return tree.getAreaRatio();
    }

    @Override
    public int getInsertionCount() {
        return tree.getInsertionCount();
    }

    @Override
    public void drawTree(DebugDraw draw) {
        tree.drawTree(draw);
    }
}
