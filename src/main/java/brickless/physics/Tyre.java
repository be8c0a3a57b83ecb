package brickless.physics;

import brickless.world.RobotModel.Wheel;

/**
 * The contact patch of a driven wheel: along the rolling direction it couples body and shaft, across it holds the body;
 * both within one circle of friction. Backlash lets the body roll freely until the gears meet; the wheel between them
 * has no mass.
 */
final class Tyre {
    private final double localX;
    private final double localY;
    private final double localCos;
    private final double localSin;
    private final double lever;
    private final boolean omni;
    /** How far the tyre can roll to either side of the middle of the gears' play, metres. */
    private final double play;
    final Shaft shaft;

    private double forwardX;
    private double forwardY;
    private double armX;
    private double armY;
    private double alongMass;
    private double acrossMass;
    private double limit;
    private double along;
    private double across;
    /** How far the motor is ahead of the tyre within the play, metres. */
    private double lead;
    private double leastSlip;
    private double mostSlip;

    Tyre(Wheel wheel, Shaft shaft, boolean ideal) {
        this.localX = wheel.position().x();
        this.localY = wheel.position().y();
        this.localCos = StrictMath.cos(wheel.headingRadians());
        this.localSin = StrictMath.sin(wheel.headingRadians());
        this.lever = (wheel.inverted() ? -1 : 1) * wheel.diameterMetres() / 2 / wheel.gearRatio();
        this.omni = wheel.omni();
        this.play = ideal ? 0 : wheel.backlashRadians() / 2 * wheel.diameterMetres() / 2;
        this.shaft = shaft;
    }

    /** Metres that the tyre rolls per radian of its motor, negative if the motor is mounted the other way round. */
    double leverMetres() {
        return lever;
    }

    void begin(BodyMotion body, double limitNewtons, double dt) {
        forwardX = localCos * body.cos - localSin * body.sin;
        forwardY = localCos * body.sin + localSin * body.cos;
        armX = body.armX(localX, localY);
        armY = body.armY(localX, localY);
        limit = limitNewtons * dt;
        if (play > 0) {
            leastSlip = (lead - play) / dt;
            mostSlip = (lead + play) / dt;
        }
        double armAlong = armX * forwardY - armY * forwardX;
        double armAcross = armX * forwardX + armY * forwardY;
        alongMass = 1 / (body.inverseMass + armAlong * armAlong * body.inverseInertia + lever * lever
                * shaft.inverseInertia());
        acrossMass = 1 / (body.inverseMass + armAcross * armAcross * body.inverseInertia);
        double size = StrictMath.sqrt(along * along + across * across);
        if (size > limit) {
            along *= limit / size;
            across *= limit / size;
        }
        apply(body, along, across);
    }

    void solve(BodyMotion body) {
        double vx = body.vx - body.spin * armY;
        double vy = body.vy + body.spin * armX;
        double slip = vx * forwardX + vy * forwardY - lever * shaft.speedRadiansPerSecond();
        double slide = omni ? 0 : vy * forwardX - vx * forwardY;
        double newAlong = along - (slip - allowed(slip)) * alongMass;
        double newAcross = across - slide * acrossMass;
        double squared = newAlong * newAlong + newAcross * newAcross;
        if (squared > limit * limit) {
            double scale = limit / StrictMath.sqrt(squared);
            newAlong *= scale;
            newAcross *= scale;
        }
        apply(body, newAlong - along, newAcross - across);
        along = newAlong;
        across = newAcross;
    }

    /** The slip nearest to what it would be without the tyre's force that keeps the gears within their play. */
    private double allowed(double slip) {
        if (play == 0) {
            return 0;
        }
        double free = slip - along / alongMass;
        return Math.max(leastSlip, Math.min(mostSlip, free));
    }

    /** Follows the gears through their play, after the step; a tyre that slips over the floor leaves them meshed. */
    void end(BodyMotion body, double dt) {
        if (play > 0) {
            double vx = body.vx - body.spin * armY;
            double vy = body.vy + body.spin * armX;
            double slip = vx * forwardX + vy * forwardY - lever * shaft.speedRadiansPerSecond();
            lead = Math.max(-play, Math.min(play, lead - slip * dt));
        }
    }

    private void apply(BodyMotion body, double alongImpulse, double acrossImpulse) {
        double px = forwardX * alongImpulse - forwardY * acrossImpulse;
        double py = forwardY * alongImpulse + forwardX * acrossImpulse;
        body.push(px, py, armX, armY);
        shaft.applyImpulse(-lever * alongImpulse);
    }
}
