package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;
import lejos.utility.Delay;

/**
 * Drives a robot with two wheels.
 *
 * <p>Of an arc, the radius is positive if the centre is to the left, and <b>the angle is the change of heading</b>:
 * {@code arc(-20, 90)} turns to the left and so drives backward. In this {@link MovePilot} differs.
 *
 * <p>A move that begins while another is in progress stops that one first, except {@link #steer(double)}, {@link
 * #steerBackward} and arcs without end, which change the speeds of the wheels as they turn. Listeners hear of a start
 * on the thread that begins the move, before the motors turn, and of a stop on a thread of the pilot; a call that waits
 * for the end of a move returns when they have heard. A stalled motor ends the move. May be used by several threads.
 *
 * @deprecated use {@link MovePilot}
 */
@Deprecated
public class DifferentialPilot implements LineFollowingMoveController {
    private static final double DEFAULT_SPEED_SHARE = 0.8;
    private static final double DEFAULT_ACCELERATION_PER_SPEED = 4;
    private static final double QUICK_ACCELERATION = 9999;
    private static final double FULL_TURN = 360;
    private static final double STRAIGHT_RATE = 100;

    /** Steering by so many percent turns on the spot. */
    private static final double SPOT_RATE = 200;

    /** Motor of the left wheel. */
    protected final RegulatedMotor _left;
    /** Motor of the right wheel. */
    protected final RegulatedMotor _right;
    /** Motor of the outer wheel of the last curve. */
    protected RegulatedMotor _outside;
    /** Degrees that the left motor turns per unit of distance. */
    protected final float _leftDegPerDistance;
    /** Degrees that the right motor turns per unit of distance. */
    protected final float _rightDegPerDistance;
    /** Kind of the present or last move. */
    protected Move.MoveType _type = Move.MoveType.STOP;

    private final DriveWheels wheels;
    private final MoveWatch watch;
    private final double trackWidth;
    private volatile double linearSpeed;
    private volatile double angularSpeed;
    private volatile double acceleration;
    private volatile double minRadius;

    /**
     * A pilot of two equal wheels.
     *
     * @param wheelDiameter diameter of a wheel
     * @param trackWidth distance between the wheels, in the same unit
     * @param leftMotor motor of the left wheel
     * @param rightMotor motor of the right wheel
     */
    public DifferentialPilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor) {
        this(wheelDiameter, trackWidth, leftMotor, rightMotor, false);
    }

    /** A pilot of two equal wheels, whose motors perhaps run in reverse; see the constructor above. */
    public DifferentialPilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor, boolean reverse) {
        this(wheelDiameter, wheelDiameter, trackWidth, leftMotor, rightMotor, reverse);
    }

    /** A pilot of two wheels, whose motors perhaps run in reverse; see the first constructor. */
    public DifferentialPilot(double leftWheelDiameter, double rightWheelDiameter, double trackWidth,
            RegulatedMotor leftMotor, RegulatedMotor rightMotor, boolean reverse) {
        _left = leftMotor;
        _right = rightMotor;
        _outside = rightMotor;
        _leftDegPerDistance = (float) (FULL_TURN / (Math.PI * leftWheelDiameter));
        _rightDegPerDistance = (float) (FULL_TURN / (Math.PI * rightWheelDiameter));
        this.trackWidth = trackWidth;
        wheels = new DriveWheels(DriveWheel.of(leftMotor, leftWheelDiameter, trackWidth, reverse),
                DriveWheel.of(rightMotor, rightWheelDiameter, trackWidth, reverse));
        watch = new MoveWatch(this, new PilotDrive());
        setLinearSpeed(getMaxLinearSpeed() * DEFAULT_SPEED_SHARE);
        setAngularSpeed(getMaxAngularSpeed() * DEFAULT_SPEED_SHARE);
        setLinearAcceleration(linearSpeed * DEFAULT_ACCELERATION_PER_SPEED);
        leftMotor.synchronizeWith(new RegulatedMotor[] {rightMotor});
    }

    /** {@inheritDoc} A move in progress becomes faster or slower at once; a resting robot's motors are set to it. */
    @Override
    public void setLinearSpeed(double speed) {
        double ratio = speed / linearSpeed;
        linearSpeed = speed;
        if (isMoving()) {
            wheels.scaleSpeed(ratio);
        } else {
            wheels.setLinearSpeed(speed);
        }
    }

    @Override
    public double getLinearSpeed() {
        return linearSpeed;
    }

    /** Sets the acceleration of turns, too, in the same units per second squared. */
    @Override
    public void setLinearAcceleration(double acceleration) {
        this.acceleration = acceleration;
        wheels.setAcceleration(acceleration);
    }

    @Override
    public double getLinearAcceleration() {
        return acceleration;
    }

    @Override
    public double getMaxLinearSpeed() {
        return wheels.slowestMaximum() / Math.max(_leftDegPerDistance, _rightDegPerDistance);
    }

    /** {@inheritDoc} Sets the motors' speeds at once, whatever they are doing. */
    @Override
    public void setAngularSpeed(double speed) {
        angularSpeed = speed;
        wheels.setAngularSpeed(speed);
    }

    @Override
    public double getAngularSpeed() {
        return angularSpeed;
    }

    /** Highest speed of turns the robot can keep up now, in degrees per second. */
    @Override
    public float getMaxRotateSpeed() {
        return (float) getMaxAngularSpeed();
    }

    @Override
    public double getMaxAngularSpeed() {
        return wheels.slowestMaximum() / wheels.greatestTurnRatio();
    }

    @Override
    public void forward() {
        driveStraight(1);
    }

    @Override
    public void backward() {
        driveStraight(-1);
    }

    private void driveStraight(int direction) {
        end();
        run(Move.MoveType.TRAVEL, direction * Double.POSITIVE_INFINITY, 0,
                () -> wheels.driveStraight(linearSpeed, acceleration, direction));
    }

    /** {@inheritDoc} Turns with the speed that the motors were last set to. */
    @Override
    public void rotateLeft() {
        end();
        run(Move.MoveType.ROTATE, 0, Double.POSITIVE_INFINITY, () -> wheels.spin(acceleration, 1));
    }

    /** {@inheritDoc} Turns with the speed that the motors were last set to. */
    @Override
    public void rotateRight() {
        end();
        run(Move.MoveType.ROTATE, 0, Double.NEGATIVE_INFINITY, () -> wheels.spin(acceleration, -1));
    }

    @Override
    public void rotate(double angle) {
        rotate(angle, false);
    }

    /** {@inheritDoc} Without end, returns at once in any case. */
    @Override
    public void rotate(double angle, boolean immediateReturn) {
        if (Double.isInfinite(angle)) {
            turn(angle > 0);
            return;
        }
        end();
        waitUnless(immediateReturn,
                run(Move.MoveType.ROTATE, 0, angle, () -> wheels.turn(angle, angularSpeed, acceleration)));
    }

    private void turn(boolean left) {
        if (left) {
            rotateLeft();
        } else {
            rotateRight();
        }
    }

    /** Stops; returns at rest, when the listeners have heard of it. */
    @Override
    public void stop() {
        stop(acceleration);
    }

    /** Stops as quickly as possible; returns at rest, when the listeners have heard of it. */
    public void quickStop() {
        wheels.setAcceleration(QUICK_ACCELERATION);
        stop(acceleration);
    }

    private void stop(double laterAcceleration) {
        wheels.halt();
        watch.end(true);
        while (isMoving()) {
            Delay.msDelay(1);
        }
        wheels.setAcceleration(laterAcceleration);
    }

    @Override
    public void travel(double distance) {
        travel(distance, false);
    }

    /** {@inheritDoc} Without end, returns at once in any case. */
    @Override
    public void travel(double distance, boolean immediateReturn) {
        if (distance == Double.POSITIVE_INFINITY) {
            forward();
        } else if (distance == Double.NEGATIVE_INFINITY) {
            backward();
        } else {
            end();
            waitUnless(immediateReturn,
                    run(Move.MoveType.TRAVEL, distance, 0, () -> wheels.travel(distance, linearSpeed, acceleration)));
        }
    }

    @Override
    public void arcForward(double radius) {
        steer(turnRate(radius));
    }

    @Override
    public void arcBackward(double radius) {
        steerBackward(turnRate(radius));
    }

    @Override
    public void arc(double radius, double angle) {
        arc(radius, angle, false);
    }

    /** {@inheritDoc} The angle is the change of heading. With an infinite radius drives forward without end. */
    @Override
    public void arc(double radius, double angle, boolean immediateReturn) {
        if (Double.isInfinite(radius)) {
            forward();
        } else {
            steer(turnRate(radius), angle, immediateReturn);
        }
    }

    @Override
    public void travelArc(double radius, double distance) {
        travelArc(radius, distance, false);
    }

    /** {@inheritDoc} @throws IllegalArgumentException if the radius is 0 */
    @Override
    public void travelArc(double radius, double distance, boolean immediateReturn) {
        if (radius == 0) {
            throw new IllegalArgumentException("An arc of radius 0 has no distance");
        }
        if (Double.isInfinite(radius)) {
            travel(distance, immediateReturn);
        } else {
            arc(radius, StrictMath.toDegrees(distance / radius), immediateReturn);
        }
    }

    /** The rate to steer with for a radius. */
    private double turnRate(double radius) {
        if (Double.isInfinite(radius)) {
            return 0;
        }
        double inside = 2 * Math.abs(radius) - trackWidth;
        double outside = 2 * Math.abs(radius) + trackWidth;
        double rate = STRAIGHT_RATE * (1 - inside / outside);
        return radius < 0 ? -rate : rate;
    }

    @Override
    public void steer(double turnRate) {
        steerWithoutEnd(turnRate, 1);
    }

    @Override
    public void steerBackward(double turnRate) {
        steerWithoutEnd(turnRate, -1);
    }

    private void steerWithoutEnd(double turnRate, int direction) {
        double rate = clip(turnRate);
        double distance = direction * Double.POSITIVE_INFINITY;
        if (rate == 0) {
            steerOn(Move.MoveType.TRAVEL, distance, 0,
                    () -> wheels.driveStraight(linearSpeed, acceleration, direction));
        } else {
            Curve curve = curve(rate, direction);
            double angle = rate > 0 ? distance : -distance;
            steerOn(Move.MoveType.ARC, distance, angle, () -> wheels.driveCurve(curve, acceleration, direction));
        }
    }

    /** Steers along an arc; see {@link #steer(double, double, boolean)}. Returns when done. */
    public void steer(double turnRate, double angle) {
        steer(turnRate, angle, false);
    }

    /**
     * Steers along an arc.
     *
     * @param turnRate see {@link #steer(double)}; 0 drives forward without end
     * @param angle change of heading in degrees; 0 does nothing
     * @param immediateReturn true to return at once, false to return when done
     */
    public void steer(double turnRate, double angle, boolean immediateReturn) {
        double rate = clip(turnRate);
        if (angle == 0) {
            return;
        }
        if (rate == 0) {
            forward();
            return;
        }
        end();
        double forwardAngle = rate > 0 ? angle : -angle;
        Curve curve = curve(rate, forwardAngle > 0 ? 1 : -1);
        double radius = trackWidth * (STRAIGHT_RATE / rate - Math.signum(rate) / 2);
        WatchedMove move = run(Move.MoveType.ARC, StrictMath.toRadians(angle) * radius, angle,
                () -> wheels.followCurve(curve, acceleration, forwardAngle));
        if (!immediateReturn) {
            watch.await(move);
            wheels.leaveCurve(curve, acceleration);
        }
    }

    private static double clip(double turnRate) {
        return Math.max(-SPOT_RATE, Math.min(SPOT_RATE, turnRate));
    }

    private Curve curve(double rate, int direction) {
        Curve curve = wheels.curve(rate, linearSpeed, direction);
        _outside = curve.outside().motor();
        return curve;
    }

    /** Ends the move in progress; the robot then rests. */
    private void end() {
        if (isMoving()) {
            stop(acceleration);
        }
    }

    /** Begins a move once the one before is over. */
    private WatchedMove run(Move.MoveType type, double distance, double angle, Runnable motion) {
        watch.end(false);
        WatchedMove move = watch.begin(plan(type, distance, angle), false);
        _type = type;
        wheels.rebase();
        begun();
        return start(move, motion);
    }

    /** Begins a move in place of the one in progress, whose end is this one's beginning. */
    private void steerOn(Move.MoveType type, double distance, double angle, Runnable motion) {
        boolean goingOn = watch.isActive();
        WatchedMove move = watch.begin(plan(type, distance, angle), true);
        _type = type;
        if (goingOn) {
            wheels.rebaseAtLastReading();
        } else {
            wheels.rebase();
        }
        begun();
        start(move, motion);
    }

    /** Called when a move begins, before anybody is told. */
    void begun() {}

    /** Distance since the motors' counts were zero, negative backward. */
    float totalDistance() {
        return wheels.total().distance();
    }

    /** Change of heading in degrees since the motors' counts were zero. */
    float totalTurn() {
        return wheels.total().angle();
    }

    private WatchedMove start(WatchedMove move, Runnable motion) {
        watch.announce(move);
        if (!move.isOver()) {
            motion.run();
            watch.follow(move);
        }
        return move;
    }

    private void waitUnless(boolean immediateReturn, WatchedMove move) {
        if (!immediateReturn) {
            watch.await(move);
        }
    }

    private Move plan(Move.MoveType type, double distance, double angle) {
        return new Move(type, (float) distance, (float) angle, (float) linearSpeed, (float) angularSpeed, false);
    }

    /** For subclasses that command the motors themselves: ends the move in progress, and tells of a new one. */
    protected void movementStart() {
        end();
        watch.end(false);
        WatchedMove move = watch.begin(plan(_type, 0, 0), false);
        wheels.rebase();
        begun();
        watch.announce(move);
    }

    /** For subclasses that command the motors themselves: the motors of the move have been told. */
    protected void movementActive() {
        watch.followPresent();
    }

    @Override
    public boolean isMoving() {
        return _left.isMoving() || _right.isMoving();
    }

    /** Whether a motor is stalled. */
    public boolean isStalled() {
        return _left.isStalled() || _right.isStalled();
    }

    /** Makes increments count from here; the motors' own counts stay. */
    public void reset() {
        wheels.rebase();
    }

    /** {@inheritDoc} The pilot itself drives any arc; a navigator drives curves if this is above 0. */
    @Override
    public void setMinRadius(double radius) {
        minRadius = radius;
    }

    @Override
    public double getMinRadius() {
        return minRadius;
    }

    /** Distance since the present or last move began, negative backward. */
    public float getMovementIncrement() {
        return wheels.movement().distance();
    }

    /** Change of heading in degrees since the present or last move began. */
    public float getAngleIncrement() {
        return turned(wheels.movement());
    }

    /** What the pilot takes the change of heading for, where the wheels say this. */
    float turned(DriveWheels.Movement movement) {
        return movement.angle();
    }

    @Override
    public void addMoveListener(MoveListener listener) {
        watch.addListener(listener);
    }

    @Override
    public Move getMovement() {
        DriveWheels.Movement movement = wheels.movement();
        return new Move(_type, movement.distance(), turned(movement), isMoving());
    }

    /** The same as {@link #getAngularSpeed}. */
    public double getTurnRate() {
        return getAngularSpeed();
    }

    /** Does nothing: turns accelerate as {@link #setLinearAcceleration} says. */
    @Override
    public void setAngularAcceleration(double acceleration) {}

    /** Always 0. */
    @Override
    public double getAngularAcceleration() {
        return 0;
    }

    /**
     * The same as {@link #setLinearAcceleration}, by its name before leJOS 0.9.1.
     *
     * @deprecated not in leJOS 0.9.1
     */
    @Deprecated
    public void setAcceleration(int acceleration) {
        setLinearAcceleration(acceleration);
    }

    /** The wheels as the watch sees them. */
    private final class PilotDrive implements MoveWatch.Drive {
        @Override
        public boolean isMoving() {
            return DifferentialPilot.this.isMoving();
        }

        @Override
        public boolean isStalled() {
            return DifferentialPilot.this.isStalled();
        }

        @Override
        public void halt() {
            wheels.halt();
        }

        @Override
        public Move done(Move plan) {
            DriveWheels.Movement movement = wheels.lastMovement();
            return new Move(plan.getMoveType(), movement.distance(), turned(movement), (float) linearSpeed,
                    (float) angularSpeed, isMoving());
        }
    }
}
