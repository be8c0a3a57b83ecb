package brickless.physics;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.SolverData;
import org.jbox2d.dynamics.contacts.Velocity;

/**
 * Couples a shaft with a turret that turns on the robot: the turret's angle to the robot is the shaft's angle over the
 * gear ratio.
 */
final class TurretGear {
    /** Part of the angle error that is taken out per step. */
    private static final double CORRECTION = 0.2;

    private final Body robot;
    private final Body turret;
    private final Shaft shaft;
    private final double ratio;
    private double mass;
    private double bias;
    private double impulse;
    private double turretInverseInertia;

    /** The ratio is turret radians per shaft radian, signed. */
    TurretGear(Body robot, Body turret, Shaft shaft, double ratio) {
        this.robot = robot;
        this.turret = turret;
        this.shaft = shaft;
        this.ratio = ratio;
    }

    void begin(BodyMotion motion, SolverData data, double dt) {
        turretInverseInertia = 1 / Decimetres.inertia(1 / turret.m_invI);
        mass = 1 / (motion.inverseInertia + turretInverseInertia + ratio * ratio * shaft.inverseInertia());
        float robotAngle = data.positions[robot.m_islandIndex].a;
        float turretAngle = data.positions[turret.m_islandIndex].a;
        bias = CORRECTION / dt * (turretAngle - robotAngle - ratio * shaft.angleRadians());
        apply(motion, data, impulse);
    }

    void solve(BodyMotion motion, SolverData data) {
        double relative = data.velocities[turret.m_islandIndex].w - motion.spin - ratio * shaft.speedRadiansPerSecond();
        double change = -(relative + bias) * mass;
        impulse += change;
        apply(motion, data, change);
    }

    private void apply(BodyMotion motion, SolverData data, double amount) {
        Velocity velocity = data.velocities[turret.m_islandIndex];
        velocity.w += (float) (amount * turretInverseInertia);
        motion.spin -= amount * motion.inverseInertia;
        shaft.applyImpulse(-ratio * amount);
    }
}
