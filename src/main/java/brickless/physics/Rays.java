package brickless.physics;

import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;

/**
 * Casts rays; finds the nearest solid that is tall enough and is not the caster's own robot. What is not looked for is not computed either:
 * a ray starts inside the boxes of most parts of its own robot.
 */
final class Rays implements TreeRayCastCallback {
    private static final float GO_ON = -1;

    private final LeanWorld world;
    private final RayCastInput input = new RayCastInput();
    private final RayCastOutput output = new RayCastOutput();
    private final Vec2 bestNormal = new Vec2();
    private Solid self;
    private double least;
    private Solid best;
    private float bestFraction;

    Rays(LeanWorld world) {
        this.world = world;
    }

    void cast(Aim aim, double turnRadians, double reachMetres, double leastHeightMetres, Solid own, RayHit out) {
        double cos = StrictMath.cos(aim.headingRadians + turnRadians);
        double sin = StrictMath.sin(aim.headingRadians + turnRadians);
        input.p1.set(Decimetres.of(aim.x), Decimetres.of(aim.y));
        input.p2.set(Decimetres.of(aim.x + cos * reachMetres), Decimetres.of(aim.y + sin * reachMetres));
        input.maxFraction = 1;
        self = own;
        least = leastHeightMetres;
        best = null;
        world.castRay(this, input);
        if (best == null) {
            out.clear();
        } else {
            out.set(bestFraction * reachMetres, -(cos * bestNormal.x + sin * bestNormal.y), best);
        }
    }

    @Override public float raycastCallback(RayCastInput ray, int proxy) {
        Fixture fixture = world.fixture(proxy);
        Solid solid = (Solid) fixture.getBody().getUserData();
        if (solid == self || fixture.m_isSensor || solid instanceof ObstacleBody obstacle && obstacle.description().heightMetres() < least
                || !fixture.raycast(output, ray, 0)) {
            return GO_ON;
        }
        best = solid;
        bestFraction = output.fraction;
        bestNormal.set(output.normal);
        return output.fraction;
    }
}
