package brickless.physics;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.joints.JointEdge;

/**
 * Keeps the boxes of the broad phase around the shapes of bodies that moved.
 *
 * <p>The boxes have a margin. A robot that moved less than what was left of it when it was last looked at is certainly still inside, and
 * need not be looked at ({@link Clearance}).
 */
final class FatBoxes {
    /** More than any rounding error of a corner's place, decimetres. */
    private static final float SAFETY = 0.005f;

    private final LazyTree tree;
    private final BroadPhase broadPhase;
    private final Rotation rotation = new Rotation();
    private final Transform before = new Transform();
    private final AABB earlier = new AABB();
    private final AABB later = new AABB();
    private final Vec2 shift = new Vec2();

    FatBoxes(LazyTree tree, BroadPhase broadPhase) {
        this.tree = tree;
        this.broadPhase = broadPhase;
    }

    /** A body has moved, from {@code m_sweep.c0} and {@code a0} to where it is. */
    void follow(Body body) {
        Clearance clearance = clearance(body);
        if (clearance == null) {
            update(body);
        } else if (clearance.usedUp(farthest(body, clearance.radius()))) {
            float left = update(body);
            clearance.renew(left - SAFETY, radius(body));
        }
    }

    private static Clearance clearance(Body body) {
        for (JointEdge edge = body.m_jointList; edge != null; edge = edge.next) {
            if (edge.joint instanceof Drivetrain drivetrain) {
                return drivetrain.clearance();
            }
        }
        return null;
    }

    /** Distance of the farthest point of a body from its centre of mass. */
    private static float radius(Body body) {
        float largest = 0;
        for (Fixture fixture = body.m_fixtureList; fixture != null; fixture = fixture.m_next) {
            PolygonShape shape = (PolygonShape) fixture.m_shape;
            for (int i = 0; i < shape.m_count; i++) {
                largest = Math.max(largest, MathUtils.distance(shape.m_vertices[i], body.m_sweep.localCenter) + shape.m_radius);
            }
        }
        return largest;
    }

    /** No point of the body can have moved farther. */
    private static float farthest(Body body, float radius) {
        return Math.abs(body.m_sweep.c.x - body.m_sweep.c0.x) + Math.abs(body.m_sweep.c.y - body.m_sweep.c0.y)
                + Math.abs(body.m_sweep.a - body.m_sweep.a0) * radius;
    }

    /** Does what JBox2D does after each step; returns the least distance of a shape's box from the edge of its fat box. */
    private float update(Body body) {
        rotation.to(body.m_sweep.a0);
        before.q.s = (float) rotation.sin();
        before.q.c = (float) rotation.cos();
        Vec2 centre = body.m_sweep.localCenter;
        before.p.x = body.m_sweep.c0.x - before.q.c * centre.x + before.q.s * centre.y;
        before.p.y = body.m_sweep.c0.y - before.q.s * centre.x - before.q.c * centre.y;
        shift.x = body.m_xf.p.x - before.p.x;
        shift.y = body.m_xf.p.y - before.p.y;
        float least = Float.POSITIVE_INFINITY;
        for (Fixture fixture = body.m_fixtureList; fixture != null; fixture = fixture.m_next) {
            if (fixture.m_proxyCount > 0) {
                least = Math.min(least, update(fixture, body.m_xf));
            }
        }
        return least;
    }

    private float update(Fixture fixture, Transform now) {
        fixture.m_shape.computeAABB(earlier, before, 0);
        fixture.m_shape.computeAABB(later, now, 0);
        AABB box = fixture.getAABB(0);
        box.combine(earlier, later);
        int proxy = tree.proxyOf(fixture.m_proxies[0]);
        broadPhase.moveProxy(proxy, box, shift);
        return margin(broadPhase.getFatAABB(proxy), box);
    }

    private static float margin(AABB fat, AABB box) {
        return Math.min(Math.min(box.lowerBound.x - fat.lowerBound.x, box.lowerBound.y - fat.lowerBound.y),
                Math.min(fat.upperBound.x - box.upperBound.x, fat.upperBound.y - box.upperBound.y));
    }
}
