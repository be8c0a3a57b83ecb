package brickless.physics;

import java.util.Arrays;
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
 * A step of robots that touch nothing: its drivetrain alone decides how each moves. What JBox2D's {@code Island} would
 * compute for islands of one body each, in the same order and precision.
 *
 * <p>Some robots take turns, round by round of the solver. Within a robot every number depends on the one before; a
 * processor that looks ahead works on the next robot while it waits.
 */
final class FreeMotion {
    /** Robots that take turns: more would not fit into what a processor has at hand. */
    static final int TOGETHER = 4;

    private final Body[] bodies = new Body[TOGETHER];
    private final Drivetrain[] drivetrains = new Drivetrain[TOGETHER];
    private final SolverData data = new SolverData();
    private final Position[] positions = new Position[TOGETHER];
    private final Velocity[] velocities = new Velocity[TOGETHER];
    private int count;

    FreeMotion() {
        Arrays.setAll(positions, i -> new Position());
        Arrays.setAll(velocities, i -> new Velocity());
        data.positions = positions;
        data.velocities = velocities;
    }

    /** Adds a robot; it moves with the next ones, at the latest when {@link #finish} is called. */
    void add(Body body, Drivetrain drivetrain, TimeStep step) {
        bodies[count] = body;
        drivetrains[count++] = drivetrain;
        if (count == TOGETHER) {
            finish(step);
        }
    }

    /** Moves the robots that were added. */
    void finish(TimeStep step) {
        data.step = step;
        for (int i = 0; i < count; i++) {
            begin(bodies[i], i);
            drivetrains[i].initVelocityConstraints(data);
        }
        for (int round = 0; round < step.velocityIterations; round++) {
            for (int i = 0; i < count; i++) {
                drivetrains[i].solveVelocityConstraints(data);
            }
        }
        for (int i = 0; i < count; i++) {
            end(bodies[i], drivetrains[i].rotation(), positions[i], velocities[i], step.dt);
        }
        count = 0;
    }

    private void begin(Body body, int place) {
        body.m_islandIndex = place;
        body.m_sweep.c0.set(body.m_sweep.c);
        body.m_sweep.a0 = body.m_sweep.a;
        positions[place].c.set(body.m_sweep.c);
        positions[place].a = body.m_sweep.a;
        // adding nothing makes a positive zero of a negative one, as adding the forces does
        Velocity velocity = velocities[place];
        velocity.v.x = body.m_linearVelocity.x + 0f;
        velocity.v.y = body.m_linearVelocity.y + 0f;
        velocity.w = body.m_angularVelocity + 0f;
    }

    private static void end(Body body, Rotation rotation, Position position, Velocity velocity, float seconds) {
        limitSpeed(velocity, seconds);
        position.c.x += seconds * velocity.v.x;
        position.c.y += seconds * velocity.v.y;
        position.a += seconds * velocity.w;
        put(body, rotation, position, velocity);
    }

    private static void limitSpeed(Velocity velocity, float seconds) {
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

    private static void put(Body body, Rotation rotation, Position position, Velocity velocity) {
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
