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
 * Keeps the boxes of the broad phase around the shapes of bodies that moved: those boxes that JBox2D would have, after
 * each step.
 *
 * <p>The boxes have a margin. A robot that moved less than what was left of it when it was last looked at is certainly
 * still inside, and need not be looked at ({@link Clearance}). Where a body was before the step matters only for a new
 * box: it was within the old one.
 */
final class FatBoxes {
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
        if (clearance != null && clearance.enough(body.m_sweep)) {
            return;
        }
        if (clearance != null) {
            if (clearance.radius() < 0) {
                clearance.setRadius(radius(body));
            }
            clearance.begin(body.m_sweep);
        }
        for (Fixture fixture = body.m_fixtureList; fixture != null; fixture = fixture.m_next) {
            if (fixture.m_proxyCount > 0) {
                update(body, fixture, clearance);
            }
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
                largest = Math.max(largest, MathUtils.distance(shape.m_vertices[i], body.m_sweep.localCenter)
                        + shape.m_radius);
            }
        }
        return largest;
    }

    private void update(Body body, Fixture fixture, Clearance clearance) {
        int proxy = tree.proxyOf(fixture.m_proxies[0]);
        AABB fat = tree.getFatAABB(proxy);
        fixture.m_shape.computeAABB(later, body.m_xf, 0);
        if (!LazyTree.contains(fat, later)) {
            move(body, fixture, proxy);
        }
        if (clearance != null) {
            clearance.limit(later.lowerBound.x - fat.lowerBound.x, later.lowerBound.y - fat.lowerBound.y,
                    fat.upperBound.x - later.upperBound.x, fat.upperBound.y - later.upperBound.y);
        }
    }

    /** Gives a shape another box as JBox2D does: around where it was and where it is. */
    private void move(Body body, Fixture fixture, int proxy) {
        rotation.to(body.m_sweep.a0);
        before.q.s = (float) rotation.sin();
        before.q.c = (float) rotation.cos();
        Vec2 centre = body.m_sweep.localCenter;
        before.p.x = body.m_sweep.c0.x - before.q.c * centre.x + before.q.s * centre.y;
        before.p.y = body.m_sweep.c0.y - before.q.s * centre.x - before.q.c * centre.y;
        shift.x = body.m_xf.p.x - before.p.x;
        shift.y = body.m_xf.p.y - before.p.y;
        fixture.m_shape.computeAABB(earlier, before, 0);
        AABB box = fixture.getAABB(0);
        box.combine(earlier, later);
        broadPhase.moveProxy(proxy, box, shift);
    }
}
