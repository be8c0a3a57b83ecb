package brickless.physics;

import brickless.world.RobotModel.Turret;
import org.jbox2d.dynamics.Body;

/** A turret of a robot: the angle at which it stands, and its body if it has an outline. */
final class Turntable {
    final Turret description;
    final Shaft shaft;
    /**
     * Turret radians (clockwise) per motor radian: motors turn turrets to the left when they run forward, unless
     * inverted.
     */
    final double ratio;
    /** The body that turns, or null for a turret without an outline. */
    final Body body;

    Turntable(Turret description, Shaft shaft, Body body) {
        this.description = description;
        this.shaft = shaft;
        this.body = body;
        this.ratio = ratio(description);
    }

    static double ratio(Turret turret) {
        return (turret.inverted() ? 1 : -1) / turret.gearRatio();
    }

    /** Clockwise angle against the robot, radians. */
    double angleRadians(Body robot) {
        return body == null ? shaft.angleRadians() * ratio : (double) body.getAngle() - robot.getAngle();
    }
}
