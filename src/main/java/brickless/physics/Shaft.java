package brickless.physics;

/**
 * A motor's output shaft: it carries the motor's inertia and torque, and is coupled to tyres or a turret by the {@link
 * Drivetrain}.
 *
 * <p>Angles are radians, forward of the motor positive. The motor's torque is an affine function of speed (back-EMF),
 * which lets a step be solved implicitly: {@code torque = driving − damping × speed}, less Coulomb friction.
 */
public final class Shaft {
    /** Inertia of a wheel hub without a motor: assumption, 20 g at 20 mm radius. */
    static final double BARE_INERTIA = 8e-6;
    /** Friction of a hub without a motor: assumption. */
    static final double BARE_FRICTION = 1e-3;

    private double angle;
    private double speed;
    private double inertia = BARE_INERTIA;
    private double driving;
    private double damping;
    private double friction = BARE_FRICTION;
    private double load;
    private boolean stops;
    /** Whether it was found at rest, and nothing has happened to it since. */
    private boolean resting;
    private double lowerStop = Double.NEGATIVE_INFINITY;
    private double upperStop = Double.POSITIVE_INFINITY;

    private double inverseInertia;
    private double frictionLimit;
    private double frictionImpulse;
    private double stopImpulse;
    private double slowest;
    private double fastest;

    /** Angle turned since the start, radians. */
    public double angleRadians() {
        return angle;
    }

    /** Angular velocity at the end of the last step, radians per second. */
    public double speedRadiansPerSecond() {
        return speed;
    }

    /** Inertia that turns with the shaft, kg·m², without what its tyres or turrets couple to it. */
    public double inertia() {
        return inertia;
    }

    /** Plugs a motor in: its inertia at the output shaft, kg·m². */
    public void setInertia(double kilogramSquareMetres) {
        inertia = kilogramSquareMetres + BARE_INERTIA;
    }

    /** Takes the motor out: only the hub remains. */
    public void unplug() {
        inertia = BARE_INERTIA;
        drive(0, 0, BARE_FRICTION);
    }

    /**
     * Sets the motor's torque for the coming steps.
     *
     * @param torqueNewtonMetres torque at standstill
     * @param dampingNewtonMetreSeconds torque lost per radian per second
     * @param frictionNewtonMetres Coulomb friction, at standstill the breakaway torque
     */
    public void drive(double torqueNewtonMetres, double dampingNewtonMetreSeconds, double frictionNewtonMetres) {
        driving = torqueNewtonMetres;
        damping = dampingNewtonMetreSeconds;
        friction = frictionNewtonMetres;
        resting = false;
    }

    /** A constant outer torque on the shaft in newton metres, forward positive: what hangs on an arm, or a hand. */
    public void setLoadTorque(double newtonMetres) {
        load = newtonMetres;
        resting = false;
    }

    /** Hard stops; infinite values remove them. */
    public void setStops(double lowerRadians, double upperRadians) {
        lowerStop = lowerRadians;
        upperStop = upperRadians;
        resting = false;
        stops = lowerRadians > Double.NEGATIVE_INFINITY || upperRadians < Double.POSITIVE_INFINITY;
    }

    /** Whether a step would leave it as it is, unless a tyre or a turret turns it. */
    boolean rests() {
        if (!resting && speed == 0 && driving + load == 0 && frictionImpulse == 0 && !stops) {
            // not a negative zero, as after a step
            speed = 0;
            resting = true;
        }
        return resting;
    }

    /** Applies the motor's torque to the free shaft and the last step's friction as a first guess. */
    void begin(double dt) {
        double effective = inertia + damping * dt / 2;
        inverseInertia = 1 / effective;
        speed = ((inertia - damping * dt / 2) * speed + (driving + load) * dt) * inverseInertia;
        frictionLimit = friction * dt;
        frictionImpulse = clamp(frictionImpulse, frictionLimit);
        speed += frictionImpulse * inverseInertia;
        if (stops) {
            slowest = (lowerStop - angle) / dt;
            fastest = (upperStop - angle) / dt;
        }
        stopImpulse = 0;
    }

    /** One relaxation of friction and stops. */
    void solve() {
        if (speed == 0 && frictionImpulse == 0 && !stops) {
            return;
        }
        double wanted = frictionImpulse - speed / inverseInertia;
        double accumulated = clamp(wanted, frictionLimit);
        speed += (accumulated - frictionImpulse) * inverseInertia;
        frictionImpulse = accumulated;
        if (stops) {
            solveStops();
        }
    }

    private void solveStops() {
        double free = speed - stopImpulse * inverseInertia;
        double bounded = Math.max(slowest, Math.min(fastest, free));
        stopImpulse = (bounded - free) / inverseInertia;
        speed = bounded;
    }

    void applyImpulse(double newtonMetreSeconds) {
        speed += newtonMetreSeconds * inverseInertia;
    }

    double inverseInertia() {
        return inverseInertia;
    }

    void end(double dt) {
        angle += speed * dt;
    }

    private static double clamp(double value, double limit) {
        return value > limit ? limit : Math.max(value, -limit);
    }
}
