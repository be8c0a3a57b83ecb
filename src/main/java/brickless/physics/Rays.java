package brickless.physics;

import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;

/** Casts rays; finds the nearest solid that is tall enough and is not the caster's own robot. */
final class Rays implements RayCastCallback {
    private static final float IGNORE = -1;

    private final org.jbox2d.dynamics.World world;
    private final Vec2 from = new Vec2();
    private final Vec2 to = new Vec2();
    private final Vec2 bestNormal = new Vec2();
    private Solid self;
    private double least;
    private Solid best;
    private float bestFraction;

    Rays(org.jbox2d.dynamics.World world) {
        this.world = world;
    }

    void cast(Aim aim, double turnRadians, double reachMetres, double leastHeightMetres, Solid own, RayHit out) {
        double cos = StrictMath.cos(aim.headingRadians + turnRadians);
        double sin = StrictMath.sin(aim.headingRadians + turnRadians);
        from.set(Decimetres.of(aim.x), Decimetres.of(aim.y));
        to.set(Decimetres.of(aim.x + cos * reachMetres), Decimetres.of(aim.y + sin * reachMetres));
        self = own;
        least = leastHeightMetres;
        best = null;
        world.raycast(this, from, to);
        if (best == null) {
            out.clear();
        } else {
            double against = -(cos * bestNormal.x + sin * bestNormal.y);
            out.set(bestFraction * reachMetres, StrictMath.acos(Math.max(-1, Math.min(1, against))), best);
        }
    }

    @Override public float reportFixture(Fixture fixture, Vec2 point, Vec2 normal, float fraction) {
        Solid solid = (Solid) fixture.getBody().getUserData();
        if (fixture.isSensor() || solid == self
                || solid instanceof ObstacleBody obstacle && obstacle.description().heightMetres() < least) {
            return IGNORE;
        }
        best = solid;
        bestFraction = fraction;
        bestNormal.set(normal);
        return fraction;
    }
}
