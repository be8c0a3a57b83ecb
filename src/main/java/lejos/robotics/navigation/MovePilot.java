package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;

/**
 * Drives a robot by its chassis.
 *
 * <p>Of an arc, <b>the sign of the angle says whether to drive forward</b> (positive) or backward, that of the radius
 * to which side: {@code arc(-20, 90)} drives forward to the right.
 *
 * <p>Speeds and accelerations take effect at the next move. A move that begins while another is in progress stops that
 * one first. Listeners hear of a start on the thread that begins the move, the motors turning already, and of a stop on
 * a thread of the pilot; a call that waits for the end of a move returns when they have heard. A stalled motor ends the
 * move. May be used by several threads.
 */
public class MovePilot implements ArcRotateMoveController {
    private static final double DEFAULT_SPEED_SHARE = 0.8;
    private static final double DEFAULT_ACCELERATION_PER_SPEED = 4;

    private final Chassis chassis;
    private final MoveWatch watch;
    private volatile double linearSpeed;
    private volatile double angularSpeed;
    private volatile double linearAcceleration;
    private volatile double angularAcceleration;
    private volatile double minRadius;

    /**
     * A pilot of two equal wheels.
     *
     * @param wheelDiameter diameter of a wheel
     * @param trackWidth distance between the wheels, in the same unit
     * @param leftMotor motor of the left wheel
     * @param rightMotor motor of the right wheel
     * @deprecated describe the wheels with {@link WheeledChassis}
     */
    @Deprecated
    public MovePilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor, RegulatedMotor rightMotor) {
        this(wheelDiameter, trackWidth, leftMotor, rightMotor, false);
    }

    /**
     * A pilot of two equal wheels, whose motors perhaps run in reverse; see the constructor above.
     *
     * @deprecated describe the wheels with {@link WheeledChassis}
     */
    @Deprecated
    public MovePilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor, RegulatedMotor rightMotor,
            boolean reverse) {
        this(wheelDiameter, wheelDiameter, trackWidth, leftMotor, rightMotor, reverse);
    }

    /**
     * A pilot of two wheels, whose motors perhaps run in reverse; see the first constructor.
     *
     * @deprecated describe the wheels with {@link WheeledChassis}
     */
    @Deprecated
    public MovePilot(double leftWheelDiameter, double rightWheelDiameter, double trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor, boolean reverse) {
        this(new WheeledChassis(new Wheel[] {
            WheeledChassis.modelWheel(leftMotor, leftWheelDiameter).offset(trackWidth / 2).invert(reverse),
            WheeledChassis.modelWheel(rightMotor, rightWheelDiameter).offset(-trackWidth / 2).invert(reverse)},
            WheeledChassis.TYPE_DIFFERENTIAL));
    }

    /** A pilot whose speeds are 80 % of what the chassis can do now, reached in a quarter of a second. */
    public MovePilot(Chassis chassis) {
        this.chassis = chassis;
        this.watch = new MoveWatch(this, new ChassisDrive(chassis));
        this.minRadius = chassis.getMinRadius();
        double share = DEFAULT_SPEED_SHARE;
        setSpeeds(share * chassis.getMaxLinearSpeed(), share * chassis.getMaxAngularSpeed());
        setAccelerations(linearSpeed * DEFAULT_ACCELERATION_PER_SPEED, angularSpeed * DEFAULT_ACCELERATION_PER_SPEED);
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless it is above 0 */
    @Override
    public void setLinearAcceleration(double acceleration) {
        setAccelerations(acceleration, angularAcceleration);
    }

    @Override
    public double getLinearAcceleration() {
        return linearAcceleration;
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless it is above 0 */
    @Override
    public void setAngularAcceleration(double acceleration) {
        setAccelerations(linearAcceleration, acceleration);
    }

    @Override
    public double getAngularAcceleration() {
        return angularAcceleration;
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless it is above 0 */
    @Override
    public void setLinearSpeed(double speed) {
        setSpeeds(speed, angularSpeed);
    }

    @Override
    public double getLinearSpeed() {
        return linearSpeed;
    }

    @Override
    public double getMaxLinearSpeed() {
        return chassis.getMaxLinearSpeed();
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless it is above 0 */
    @Override
    public void setAngularSpeed(double speed) {
        setSpeeds(linearSpeed, speed);
    }

    @Override
    public double getAngularSpeed() {
        return angularSpeed;
    }

    @Override
    public double getMaxAngularSpeed() {
        return chassis.getMaxAngularSpeed();
    }

    private void setSpeeds(double linear, double angular) {
        chassis.setSpeed(linear, angular);
        linearSpeed = linear;
        angularSpeed = angular;
    }

    private void setAccelerations(double linear, double angular) {
        chassis.setAcceleration(linear, angular);
        linearAcceleration = linear;
        angularAcceleration = angular;
    }

    @Override
    public double getMinRadius() {
        return minRadius;
    }

    /** Sets the least radius of an arc. If it is above 0, the robot refuses to turn on the spot. */
    @Override
    public void setMinRadius(double radius) {
        minRadius = radius;
    }

    @Override
    public void forward() {
        travel(Double.POSITIVE_INFINITY, true);
    }

    @Override
    public void backward() {
        travel(Double.NEGATIVE_INFINITY, true);
    }

    @Override
    public void travel(double distance) {
        travel(distance, false);
    }

    @Override
    public void travel(double distance, boolean immediateReturn) {
        if (!watch.isActive() && chassis.isMoving()) {
            chassis.stop();
        }
        drive(plan(Move.MoveType.TRAVEL, distance, 0), () -> chassis.travel(distance), immediateReturn);
    }

    @Override
    public void arcForward(double radius) {
        arc(radius, Double.POSITIVE_INFINITY, true);
    }

    @Override
    public void arcBackward(double radius) {
        arc(radius, Double.NEGATIVE_INFINITY, true);
    }

    @Override
    public void arc(double radius, double angle) {
        arc(radius, angle, false);
    }

    @Override
    public void travelArc(double radius, double distance) {
        travelArc(radius, distance, false);
    }

    /**
     * {@inheritDoc} Forward if the distance is positive, whatever the sign of the radius.
     *
     * @throws IllegalArgumentException if the radius is 0
     */
    @Override
    public void travelArc(double radius, double distance, boolean immediateReturn) {
        if (radius == 0) {
            throw new IllegalArgumentException("An arc of radius 0 has no distance");
        }
        if (Double.isInfinite(radius)) {
            travel(distance, immediateReturn);
        } else {
            arc(radius, StrictMath.toDegrees(distance / Math.abs(radius)), immediateReturn);
        }
    }

    @Override
    public void rotate(double angle) {
        rotate(angle, false);
    }

    @Override
    public void rotate(double angle, boolean immediateReturn) {
        arc(0, angle, immediateReturn);
    }

    @Override
    public void rotateLeft() {
        rotate(Double.POSITIVE_INFINITY, true);
    }

    @Override
    public void rotateRight() {
        rotate(Double.NEGATIVE_INFINITY, true);
    }

    /**
     * {@inheritDoc} Forward if the angle is positive, whatever the sign of the radius.
     *
     * @throws RuntimeException if the radius is less than {@link #getMinRadius}
     */
    @Override
    public void arc(double radius, double angle, boolean immediateReturn) {
        if (Math.abs(radius) < minRadius) {
            throw new RuntimeException("The radius " + radius + " is less than the least, " + minRadius);
        }
        drive(arcPlan(radius, angle), () -> chassis.arc(radius, angle), immediateReturn);
    }

    private Move arcPlan(double radius, double angle) {
        if (radius == 0) {
            return plan(Move.MoveType.ROTATE, 0, angle);
        }
        if (Double.isInfinite(radius)) {
            return plan(Move.MoveType.TRAVEL, Math.signum(angle) * Double.POSITIVE_INFINITY, 0);
        }
        return plan(Move.MoveType.ARC, StrictMath.toRadians(angle) * radius, angle);
    }

    private Move plan(Move.MoveType type, double distance, double angle) {
        return new Move(type, (float) distance, (float) angle, (float) linearSpeed, (float) angularSpeed, false);
    }

    private void drive(Move plan, Runnable motion, boolean immediateReturn) {
        watch.end(false);
        WatchedMove move = watch.begin(plan, false);
        chassis.moveStart();
        motion.run();
        watch.announce(move);
        watch.follow(move);
        if (!immediateReturn) {
            watch.await(move);
        }
    }

    /** Stops; returns at rest, when the listeners have heard of it. */
    @Override
    public void stop() {
        chassis.stop();
        watch.end(true);
    }

    @Override
    public boolean isMoving() {
        return chassis.isMoving();
    }

    /** What was done so far of the move in progress; a move of type STOP if there is none. */
    @Override
    public Move getMovement() {
        return watch.progress();
    }

    @Override
    public void addMoveListener(MoveListener listener) {
        watch.addListener(listener);
    }

    /** A chassis as the watch sees it. */
    private record ChassisDrive(Chassis chassis) implements MoveWatch.Drive {
        @Override
        public boolean isMoving() {
            return chassis.isMoving();
        }

        @Override
        public boolean isStalled() {
            return chassis.isStalled();
        }

        @Override
        public void halt() {
            chassis.stop();
        }

        @Override
        public Move done(Move plan) {
            return chassis.getDisplacement(new Move(plan.getMoveType(), 0, 0, plan.getTravelSpeed(),
                    plan.getRotateSpeed(), true));
        }
    }
}
