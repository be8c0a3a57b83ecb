package brickless.physics;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.contacts.Position;
import org.jbox2d.dynamics.contacts.Velocity;

/**
 * Velocity of a robot's body in SI units while a step is being solved, read from and written back to JBox2D's solver.
 */
final class BodyMotion {
    double vx;
    double vy;
    double spin;
    double cos;
    double sin;
    double inverseMass;
    double inverseInertia;
    private final Rotation rotation;
    private float solverInverseInertia = Float.NaN;
    private double centreX;
    private double centreY;

    BodyMotion(Rotation rotation) {
        this.rotation = rotation;
    }

    void begin(Body body, Position position) {
        if (body.m_invI != solverInverseInertia || body.m_invMass != inverseMass) {
            weigh(body);
        }
        cos = rotation.to(position.a).cos();
        sin = rotation.sin();
    }

    /** Takes over what changes only when the body gets another shape. */
    private void weigh(Body body) {
        solverInverseInertia = body.m_invI;
        inverseMass = body.m_invMass;
        inverseInertia = body.m_invI == 0 ? 0 : 1 / Decimetres.inertia(1 / body.m_invI);
        centreX = Decimetres.metres(body.m_sweep.localCenter.x);
        centreY = Decimetres.metres(body.m_sweep.localCenter.y);
    }

    void read(Velocity velocity) {
        vx = Decimetres.metres(velocity.v.x);
        vy = Decimetres.metres(velocity.v.y);
        spin = velocity.w;
    }

    /** Velocity after the step, when the solver has let go of the body. */
    void read(Body body) {
        vx = Decimetres.metres(body.m_linearVelocity.x);
        vy = Decimetres.metres(body.m_linearVelocity.y);
        spin = body.m_angularVelocity;
    }

    void write(Velocity velocity) {
        velocity.v.x = Decimetres.of(vx);
        velocity.v.y = Decimetres.of(vy);
        velocity.w = (float) spin;
    }

    /** World x of the arm from the centre of mass to a point of the robot's own frame. */
    double armX(double localX, double localY) {
        return cos * (localX - centreX) - sin * (localY - centreY);
    }

    /** World y of the arm from the centre of mass to a point of the robot's own frame. */
    double armY(double localX, double localY) {
        return sin * (localX - centreX) + cos * (localY - centreY);
    }

    void push(double impulseX, double impulseY, double armX, double armY) {
        vx += impulseX * inverseMass;
        vy += impulseY * inverseMass;
        spin += (armX * impulseY - armY * impulseX) * inverseInertia;
    }
}
