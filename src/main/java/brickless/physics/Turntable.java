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
    /** How far the turret can be turned to either side of the middle of its gears' play, radians. */
    final double play;
    /** The body that turns, or null for a turret without an outline. */
    final Body body;
    /** Where a turret without an outline stands: it rests until the gears take it along. */
    private double angle;

    Turntable(Turret description, Shaft shaft, Body body, boolean ideal) {
        this.description = description;
        this.shaft = shaft;
        this.body = body;
        this.ratio = ratio(description);
        this.play = ideal ? 0 : description.backlashRadians() / 2;
    }

    static double ratio(Turret turret) {
        return (turret.inverted() ? 1 : -1) / turret.gearRatio();
    }

    /** Clockwise angle against the robot, radians. */
    double angleRadians(Body robot) {
        return body == null ? angle : (double) body.getAngle() - robot.getAngle();
    }

    /** Takes a turret without an outline along, after a step. */
    void finish() {
        double driven = shaft.angleRadians() * ratio;
        angle = Math.max(driven - play, Math.min(driven + play, angle));
    }
}
