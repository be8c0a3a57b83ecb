package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.broadphase.BroadPhaseStrategy;
import org.jbox2d.collision.broadphase.DynamicTree;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The tree in arrays has the numbers, boxes, shape and order of JBox2D's. */
class BoxTreeTest {
    private static final int CHANGES = 20_000;
    private static final float SIDE = 100;

    private final BroadPhaseStrategy own = new BoxTree();
    private final BroadPhaseStrategy theirs = new DynamicTree();
    private final List<Integer> proxies = new ArrayList<>();
    private Random random;

    private AABB box(float largest) {
        float x = random.nextFloat() * SIDE;
        float y = random.nextFloat() * SIDE;
        return new AABB(new Vec2(x, y), new Vec2(x + largest * random.nextFloat(), y + largest * random.nextFloat()));
    }

    /** New leaves at first, then all kinds of changes. */
    private void change(int number) {
        int kind = proxies.size() < 60 ? 0 : random.nextInt(10);
        if (kind < 2 && proxies.size() < 400) {
            AABB box = box(random.nextInt(20) == 0 ? SIDE : 3);
            int proxy = own.createProxy(box, number);
            assertThat(proxy).isEqualTo(theirs.createProxy(box, number));
            proxies.add(proxy);
        } else if (kind < 3) {
            int proxy = proxies.remove(random.nextInt(proxies.size()));
            own.destroyProxy(proxy);
            theirs.destroyProxy(proxy);
        } else {
            int proxy = proxies.get(random.nextInt(proxies.size()));
            AABB box = box(3);
            Vec2 shift = new Vec2(random.nextFloat() - 0.5f, random.nextInt(5) == 0 ? 0 : random.nextFloat() - 0.5f);
            own.moveProxy(proxy, box, shift);
            theirs.moveProxy(proxy, box, shift);
        }
    }

    private static List<Integer> met(BroadPhaseStrategy tree, AABB box) {
        List<Integer> met = new ArrayList<>();
        tree.query(met::add, box);
        return met;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void anyChangesLeadToTheTreeOfJBox2D(long seed) {
        random = new Random(seed);
        AABB everything = new AABB(new Vec2(-2 * SIDE, -2 * SIDE), new Vec2(4 * SIDE, 4 * SIDE));
        int overlaps = 0;
        for (int i = 0; i < CHANGES; i++) {
            change(i);
            AABB somewhere = box(30);
            assertThat(met(own, somewhere)).as("change %d", i).isEqualTo(met(theirs, somewhere));
            overlaps += met(own, somewhere).size();
            if (i % 50 == 0) {
                assertThat(met(own, everything)).as("change %d", i).isEqualTo(met(theirs, everything))
                        .hasSameSizeAs(proxies);
                assertThat(own.getHeight()).isEqualTo(theirs.getHeight()).isEqualTo(own.computeHeight());
                assertThat(own.getMaxBalance()).isEqualTo(theirs.getMaxBalance());
                assertThat(own.getAreaRatio()).isCloseTo(theirs.getAreaRatio(), within(1e-3f));
                assertThat(own.getInsertionCount()).isEqualTo(theirs.getInsertionCount());
                for (int proxy : proxies) {
                    assertThat(own.getFatAABB(proxy).toString()).isEqualTo(theirs.getFatAABB(proxy).toString());
                    assertThat(own.getUserData(proxy)).isEqualTo(theirs.getUserData(proxy));
                }
            }
        }
        assertThat(overlaps).isGreaterThan(CHANGES);
    }

    @ParameterizedTest
    @ValueSource(longs = {4, 5})
    void aRayGetsToAllBoxesThatJBox2DWouldShowIt(long seed) {
        random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            change(i);
            RayCastInput ray = new RayCastInput();
            ray.p1.set(random.nextFloat() * SIDE, random.nextFloat() * SIDE);
            ray.p2.set(random.nextFloat() * SIDE, random.nextFloat() * SIDE);
            ray.maxFraction = 1;
            List<Integer> shown = new ArrayList<>();
            own.raycast((rest, proxy) -> shown.add(proxy) ? -1 : 0, ray);
            theirs.raycast((rest, proxy) -> {
                assertThat(shown).contains(proxy);
                return -1;
            }, ray);
        }
    }
}
