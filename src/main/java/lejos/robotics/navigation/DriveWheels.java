package lejos.robotics.navigation;

/**
 * Two driving wheels, commanded together.
 *
 * <p>This object's lock keeps what belongs together together: commands to both motors, and readings of both.
 */
final class DriveWheels {
    private static final double FULL_RATE = 100;

    private final DriveWheel left;
    private final DriveWheel right;

    // Guarded by this.
    private Reading base;
    private Reading last;

    DriveWheels(DriveWheel left, DriveWheel right) {
        this.left = left;
        this.right = right;
        base = read();
        last = base;
    }

    /** What both wheels have done: a distance and a change of heading in degrees. */
    record Movement(float distance, float angle) {}

    private record Reading(int left, int right) {}

    private Reading read() {
        return new Reading(left.turned(), right.turned());
    }

    /** Makes movements count from here. */
    synchronized void rebase() {
        base = read();
    }

    /** Makes movements count from where the last one was asked for that ended a move. */
    synchronized void rebaseAtLastReading() {
        base = last;
    }

    /** What was done until now. */
    synchronized Movement movement() {
        return since(read());
    }

    /** What was done since the motors' counts were zero. */
    Movement total() {
        return between(new Reading(0, 0), read());
    }

    /** What was done until now, where the next move may go on. */
    synchronized Movement lastMovement() {
        last = read();
        return since(last);
    }

    private Movement since(Reading now) {
        return between(base, now);
    }

    private Movement between(Reading from, Reading to) {
        float leftDegrees = to.left - from.left;
        float rightDegrees = to.right - from.right;
        float distance = (leftDegrees / left.degPerDistance() + rightDegrees / right.degPerDistance()) / 2;
        float angle = (rightDegrees / right.turnRatio() - leftDegrees / left.turnRatio()) / 2;
        return new Movement(distance, angle);
    }

    /** Highest speed of the slower motor in degrees per second. */
    float slowestMaximum() {
        return Math.min(left.motor().getMaxSpeed(), right.motor().getMaxSpeed());
    }

    float greatestTurnRatio() {
        return Math.max(left.turnRatio(), right.turnRatio());
    }

    void setLinearSpeed(double speed) {
        together(() -> {
            left.setLinearSpeed(speed);
            right.setLinearSpeed(speed);
        });
    }

    void setAngularSpeed(double speed) {
        together(() -> {
            left.setAngularSpeed(speed);
            right.setAngularSpeed(speed);
        });
    }

    void setAcceleration(double acceleration) {
        together(() -> {
            left.setAcceleration(acceleration);
            right.setAcceleration(acceleration);
        });
    }

    /** Makes both wheels faster or slower as they turn. */
    void scaleSpeed(double ratio) {
        together(() -> {
            left.motor().setSpeed((int) Math.round(left.motor().getSpeed() * ratio));
            right.motor().setSpeed((int) Math.round(right.motor().getSpeed() * ratio));
        });
    }

    /** Begins to slow down to rest. */
    void halt() {
        together(() -> {
            left.motor().stop(true);
            right.motor().stop(true);
        });
    }

    /** Begins to drive straight ahead (1) or back (−1). */
    void driveStraight(double speed, double acceleration, int direction) {
        setAcceleration(acceleration);
        setLinearSpeed(speed);
        together(() -> {
            left.run(direction);
            right.run(direction);
        });
    }

    /** Begins to turn on the spot to the left (1) or right (−1), with the motors' present speeds. */
    void spin(double acceleration, int direction) {
        setAcceleration(acceleration);
        together(() -> {
            right.run(direction);
            left.run(-direction);
        });
    }

    /** Begins to drive a distance. */
    void travel(double distance, double speed, double acceleration) {
        setAcceleration(acceleration);
        setLinearSpeed(speed);
        together(() -> {
            left.rotate(distance * left.degPerDistance());
            right.rotate(distance * right.degPerDistance());
        });
    }

    /** Begins to turn on the spot by an angle in degrees. */
    void turn(double angle, double speed, double acceleration) {
        setAcceleration(acceleration);
        setAngularSpeed(speed);
        together(() -> {
            left.rotate(-angle * left.turnRatio());
            right.rotate(angle * right.turnRatio());
        });
    }

    /** The curve for a steering rate other than 0. */
    Curve curve(double rate, double linearSpeed, int direction) {
        double ratio = 1 - Math.abs(rate) / FULL_RATE;
        return rate > 0 ? Curve.of(right, left, ratio, linearSpeed, direction)
                : Curve.of(left, right, ratio, linearSpeed, direction);
    }

    /** Begins to drive along a curve, forward (1) or backward (−1). */
    void driveCurve(Curve curve, double acceleration, int direction) {
        together(() -> {
            curve.prepare(acceleration);
            curve.outside().run(direction);
            curve.inside().run(direction * curve.ratio());
        });
    }

    /** Begins to drive along a curve that turns the robot by an angle in degrees, forward if positive. */
    void followCurve(Curve curve, double acceleration, double angle) {
        int outsideDegrees = (int) (2 * angle * curve.outside().turnRatio() / (1 - curve.ratio()));
        double insideShare = curve.ratio() * curve.inside().turnRatio() / curve.outside().turnRatio();
        together(() -> {
            curve.prepare(acceleration);
            curve.inside().rotate(outsideDegrees * insideShare);
            curve.outside().rotate(outsideDegrees);
        });
    }

    /** After a curve, makes both motors alike again. */
    void leaveCurve(Curve curve, double acceleration) {
        setAcceleration(acceleration);
        curve.inside().motor().setSpeed(curve.outside().motor().getSpeed());
    }

    private synchronized void together(Runnable commands) {
        left.motor().startSynchronization();
        try {
            commands.run();
        } finally {
            left.motor().endSynchronization();
        }
    }
}
