package brickless.physics;

import brickless.world.RobotModel.Caster;

/** The contact of a free support: Coulomb friction against any motion over the floor. */
final class Skid {
    private final double localX;
    private final double localY;
    private final double coefficient;

    private double armX;
    private double armY;
    private double massX;
    private double massY;
    private double limit;
    private double impulseX;
    private double impulseY;

    Skid(Caster caster) {
        localX = caster.position().x();
        localY = caster.position().y();
        coefficient = caster.dragCoefficient();
    }

    void begin(BodyMotion body, double loadNewtons, double dt) {
        armX = body.armX(localX, localY);
        armY = body.armY(localX, localY);
        massX = 1 / (body.inverseMass + armY * armY * body.inverseInertia);
        massY = 1 / (body.inverseMass + armX * armX * body.inverseInertia);
        limit = coefficient * loadNewtons * dt;
        double size = StrictMath.sqrt(impulseX * impulseX + impulseY * impulseY);
        if (size > limit) {
            impulseX *= limit / size;
            impulseY *= limit / size;
        }
        body.push(impulseX, impulseY, armX, armY);
    }

    void solve(BodyMotion body) {
        double newX = impulseX - (body.vx - body.spin * armY) * massX;
        double newY = impulseY - (body.vy + body.spin * armX) * massY;
        double squared = newX * newX + newY * newY;
        if (squared > limit * limit) {
            double scale = limit / StrictMath.sqrt(squared);
            newX *= scale;
            newY *= scale;
        }
        body.push(newX - impulseX, newY - impulseY, armX, armY);
        impulseX = newX;
        impulseY = newY;
    }
}
