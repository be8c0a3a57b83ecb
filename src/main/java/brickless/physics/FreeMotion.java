package brickless.physics;

import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.SolverData;
import org.jbox2d.dynamics.TimeStep;
import org.jbox2d.dynamics.contacts.Position;
import org.jbox2d.dynamics.contacts.Velocity;

/**
 * A step of a robot that touches nothing: its drivetrain alone decides how it moves. What JBox2D's {@code Island} would compute for an
 * island of this one body, in the same order and precision.
 */
final class FreeMotion {
    private final SolverData data = new SolverData();
    private final Position position = new Position();
    private final Velocity velocity = new Velocity();

    FreeMotion() {
        data.positions = new Position[] {position};
        data.velocities = new Velocity[] {velocity};
    }

    void move(Body body, Drivetrain drivetrain, TimeStep step) {
        body.m_islandIndex = 0;
        body.m_sweep.c0.set(body.m_sweep.c);
        body.m_sweep.a0 = body.m_sweep.a;
        position.c.set(body.m_sweep.c);
        position.a = body.m_sweep.a;
        // adding nothing makes a positive zero of a negative one, as adding the forces does
        velocity.v.x = body.m_linearVelocity.x + 0f;
        velocity.v.y = body.m_linearVelocity.y + 0f;
        velocity.w = body.m_angularVelocity + 0f;
        data.step = step;
        drivetrain.initVelocityConstraints(data);
        for (int i = 0; i < step.velocityIterations; i++) {
            drivetrain.solveVelocityConstraints(data);
        }
        limitSpeed(step.dt);
        position.c.x += step.dt * velocity.v.x;
        position.c.y += step.dt * velocity.v.y;
        position.a += step.dt * velocity.w;
        put(body, drivetrain.rotation());
    }

    private void limitSpeed(float seconds) {
        Vec2 v = velocity.v;
        float x = v.x * seconds;
        float y = v.y * seconds;
        if (x * x + y * y > Settings.maxTranslationSquared) {
            float ratio = Settings.maxTranslation / MathUtils.sqrt(x * x + y * y);
            v.x *= ratio;
            v.y *= ratio;
        }
        float turn = seconds * velocity.w;
        if (turn * turn > Settings.maxRotationSquared) {
            velocity.w *= Settings.maxRotation / MathUtils.abs(turn);
        }
    }

    private void put(Body body, Rotation rotation) {
        Sweep sweep = body.m_sweep;
        sweep.c.set(position.c);
        sweep.a = position.a;
        body.m_linearVelocity.set(velocity.v);
        body.m_angularVelocity = velocity.w;
        body.m_sleepTime = 0;
        rotation.to(position.a);
        Rot q = body.m_xf.q;
        q.s = (float) rotation.sin();
        q.c = (float) rotation.cos();
        body.m_xf.p.x = sweep.c.x - q.c * sweep.localCenter.x + q.s * sweep.localCenter.y;
        body.m_xf.p.y = sweep.c.y - q.s * sweep.localCenter.x - q.c * sweep.localCenter.y;
    }
}
