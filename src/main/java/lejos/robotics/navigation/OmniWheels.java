package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;

/**
 * Three wheels with rollers, 120 degrees apart at equal distances from the middle, that drive around it.
 *
 * <p>Motions are forward, to the left, and counter-clockwise in radians; with a time they are speeds. This object's
 * lock keeps commands to the three motors together.
 */
final class OmniWheels {
    private static final double HALF_ROOT_3 = Math.sqrt(3) / 2;

    private final RegulatedMotor[] motors;
    private final double distance;
    private final double radius;
    private final double frontal;
    private final double parity;

    // Guarded by this.
    private double[] base;

    /** The motors of the central wheel, the one counter-clockwise and the one clockwise from it. */
    OmniWheels(RegulatedMotor[] motors, double distance, double diameter, boolean centralFrontal, boolean reverse) {
        this.motors = motors;
        this.distance = distance;
        this.radius = diameter / 2;
        this.frontal = centralFrontal ? 1 : -1;
        this.parity = reverse ? -1 : 1;
        rebase();
    }

    /** What the wheels have done. */
    record Motion(double forward, double left, double turnRadians) {
        double length() {
            return Math.sqrt(forward * forward + left * left);
        }
    }

    /** How far each motor turns, in degrees. */
    private double[] degrees(Motion motion) {
        double spin = distance * motion.turnRadians;
        double across = frontal * HALF_ROOT_3 * motion.forward;
        double along = frontal * motion.left / 2;
        return new double[] {degrees(-2 * along - spin), degrees(across + along - spin),
            degrees(along - across - spin)};
    }

    private double degrees(double way) {
        return parity * StrictMath.toDegrees(way / radius);
    }

    /** What the robot did when its motors turned by angles in degrees. */
    private Motion motion(double[] turned) {
        double a = parity * radius * StrictMath.toRadians(turned[0]);
        double b = parity * radius * StrictMath.toRadians(turned[1]);
        double c = parity * radius * StrictMath.toRadians(turned[2]);
        return new Motion(frontal * (b - c) / (2 * HALF_ROOT_3), frontal * (b + c - 2 * a) / 3,
                -(a + b + c) / (3 * distance));
    }

    synchronized void rebase() {
        base = read();
    }

    /** What was done since {@link #rebase}; curved ways count as if they were straight. */
    synchronized Motion done() {
        double[] turned = read();
        for (int i = 0; i < turned.length; i++) {
            turned[i] -= base[i];
        }
        return motion(turned);
    }

    /** Change of heading in degrees since the motors' counts were zero. */
    double totalTurnDegrees() {
        return StrictMath.toDegrees(motion(read()).turnRadians());
    }

    private double[] read() {
        double[] tachos = new double[motors.length];
        for (int i = 0; i < tachos.length; i++) {
            tachos[i] = motors[i].getTachoCount();
        }
        return tachos;
    }

    /** Begins to move with speeds per second, without end. */
    synchronized void run(Motion speed) {
        double[] wanted = degrees(speed);
        for (int i = 0; i < motors.length; i++) {
            motors[i].setSpeed((int) Math.abs(Math.round(wanted[i])));
            run(motors[i], wanted[i]);
        }
    }

    private static void run(RegulatedMotor motor, double speed) {
        if (Math.round(speed) > 0) {
            motor.forward();
        } else if (Math.round(speed) < 0) {
            motor.backward();
        } else {
            motor.stop(true);
        }
    }

    /** Begins a motion that takes a time in seconds; fractions of degrees are dropped, as by all pilots. */
    synchronized void move(Motion motion, double seconds) {
        double[] wanted = degrees(motion);
        for (int i = 0; i < motors.length; i++) {
            motors[i].setSpeed(Math.max(1, Math.abs((int) (wanted[i] / seconds))));
            motors[i].rotate((int) wanted[i], true);
        }
    }

    /** Begins to slow down to rest. */
    synchronized void halt() {
        for (RegulatedMotor motor : motors) {
            motor.stop(true);
        }
    }

    void setAcceleration(int degreesPerSecond2) {
        for (RegulatedMotor motor : motors) {
            motor.setAcceleration(degreesPerSecond2);
        }
    }

    void resetTachos() {
        for (RegulatedMotor motor : motors) {
            motor.resetTachoCount();
        }
    }

    boolean isMoving() {
        return motors[0].isMoving() || motors[1].isMoving() || motors[2].isMoving();
    }

    boolean isStalled() {
        return motors[0].isStalled() || motors[1].isStalled() || motors[2].isStalled();
    }
}
