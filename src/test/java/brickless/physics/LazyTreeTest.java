package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class LazyTreeTest {
    private static final Vec2 AT_REST = new Vec2(0, 0);

    private final LazyTree tree = new LazyTree();
    private final int proxy = tree.createProxy(box(0, 0), "crate");

    private static AABB box(float x, float y) {
        return new AABB(new Vec2(x, y), new Vec2(x + 1, y + 1));
    }

    private List<Object> found(AABB where) {
        List<Object> found = new ArrayList<>();
        tree.query(id -> found.add(tree.getUserData(id)), where);
        return found;
    }

    @Test
    void aShapeThatStaysWithinItsMarginIsNotMovedInTheTree() {
        float within = Settings.aabbExtension * 0.9f;
        assertThat(tree.moveProxy(proxy, box(within, -within), AT_REST)).isFalse();
    }

    @Test
    void aShapeThatLeavesItsMarginOnAnySideIsMoved() {
        float beyond = Settings.aabbExtension * 1.1f;
        assertThat(tree.moveProxy(proxy, box(beyond, 0), AT_REST)).isTrue();
        assertThat(tree.moveProxy(proxy, box(beyond, beyond), AT_REST)).isTrue();
        assertThat(tree.moveProxy(proxy, box(0, beyond), AT_REST)).isTrue();
        assertThat(tree.moveProxy(proxy, box(0, 0), AT_REST)).isTrue();
        assertThat(tree.moveProxy(proxy, box(0, 0), AT_REST)).isFalse();
    }

    @Test
    void aMovedShapeIsFoundWhereItIs() {
        tree.moveProxy(proxy, box(10, 10), AT_REST);
        assertThat(found(box(10.5f, 10.5f))).containsExactly("crate");
        assertThat(found(box(0, 0))).isEmpty();
    }
}
