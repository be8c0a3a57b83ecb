package brickless.physics;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.SolverData;
import org.jbox2d.dynamics.contacts.Velocity;

/**
 * Couples a shaft with a turret that turns on the robot: the turret's angle to the robot is the shaft's angle over the
 * gear ratio, give or take half the backlash.
 */
final class TurretGear {
    /** Part of the angle error that is taken out per step. */
    private static final double CORRECTION = 0.2;

    private final Body robot;
    private final Body turret;
    final Shaft shaft;
    private final double ratio;
    private final double play;
    private double mass;
    private double slowest;
    private double fastest;
    private double impulse;
    private double turretInverseInertia;

    /** The gear of a turret with a body. */
    TurretGear(Body robot, Turntable turret) {
        this.robot = robot;
        this.turret = turret.body;
        this.shaft = turret.shaft;
        this.ratio = turret.ratio;
        this.play = turret.play;
    }

    void begin(BodyMotion motion, SolverData data, double dt) {
        turretInverseInertia = 1 / Decimetres.inertia(1 / turret.m_invI);
        mass = 1 / (motion.inverseInertia + turretInverseInertia + ratio * ratio * shaft.inverseInertia());
        float robotAngle = data.positions[robot.m_islandIndex].a;
        float turretAngle = data.positions[turret.m_islandIndex].a;
        double ahead = turretAngle - robotAngle - ratio * shaft.angleRadians();
        slowest = towards(-play - ahead, play > 0 && ahead > -play, dt);
        fastest = towards(play - ahead, play > 0 && ahead < play, dt);
        apply(motion, data, impulse);
    }

    void solve(BodyMotion motion, SolverData data) {
        double relative = data.velocities[turret.m_islandIndex].w - motion.spin - ratio * shaft.speedRadiansPerSecond();
        double free = relative - impulse / mass;
        double allowed = play == 0 ? slowest : Math.max(slowest, Math.min(fastest, free));
        double change = (allowed - relative) * mass;
        impulse += change;
        apply(motion, data, change);
    }

    /** Speed that uses up what is left of the play in a step, or takes out part of what it is exceeded by. */
    private static double towards(double radians, boolean within, double dt) {
        return within ? radians / dt : CORRECTION / dt * radians;
    }

    private void apply(BodyMotion motion, SolverData data, double amount) {
        Velocity velocity = data.velocities[turret.m_islandIndex];
        velocity.w += (float) (amount * turretInverseInertia);
        motion.spin -= amount * motion.inverseInertia;
        shaft.applyImpulse(-ratio * amount);
    }
}
