package lejos.robotics.navigation;

import lejos.hardware.Power;
import lejos.robotics.Gyroscope;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.utility.Delay;

/**
 * Drives a robot with three wheels with rollers, which also drives sideways.
 *
 * <p>Directions are in degrees from straight ahead, counter-clockwise. Of an arc, the radius is positive if the centre
 * is to the left, and the angle is the change of heading.
 *
 * @deprecated use {@link MovePilot} with a holonomic chassis
 */
@Deprecated
public class OmniPilot implements ArcRotateMoveController, RegulatedMotorListener {
    private static final int ODOMETER_MILLIS = 10;
    private static final double DEGREES_PER_SECOND_PER_VOLT = 100;
    private static final float DEFAULT_LINEAR_SPEED = 10;
    private static final double DEFAULT_ANGULAR_SPEED = 90;
    private static final double FULL_RATE = 200;

    private final OmniWheels wheels;
    private final MoveWatch watch;
    private final Power battery;
    private final Gyroscope gyro;
    private final double wheelDistance;
    private final double wheelDiameter;
    private volatile double linearSpeed = DEFAULT_LINEAR_SPEED;
    private volatile boolean backward;
    private volatile double angularSpeed;
    private volatile double linearAcceleration;
    private volatile float direction;
    private volatile double minRadius;
    private volatile Move.MoveType type = Move.MoveType.STOP;

    /**
     * A pilot.
     *
     * @param wheelDistanceFromCenter distance of each wheel from the middle
     * @param wheelDiameter diameter of each wheel, in the same unit
     * @param centralMotor motor of the wheel in the middle of the front or rear
     * @param CW120degMotor motor of the wheel 120 degrees clockwise from it
     * @param CCW120degMotor motor of the wheel 120 degrees counter-clockwise from it
     * @param centralWheelFrontal whether the central wheel is in front
     * @param motorReverse whether the motors run in reverse
     * @param battery says how fast the motors can be
     */
    public OmniPilot(float wheelDistanceFromCenter, float wheelDiameter, RegulatedMotor centralMotor,
            RegulatedMotor CW120degMotor, RegulatedMotor CCW120degMotor, boolean centralWheelFrontal,
            boolean motorReverse, Power battery) {
        this(wheelDistanceFromCenter, wheelDiameter, centralMotor, CW120degMotor, CCW120degMotor, centralWheelFrontal,
                motorReverse, battery, null);
    }

    /** A pilot that takes the heading from a gyro; see the constructor above. */
    public OmniPilot(float wheelDistanceFromCenter, float wheelDiameter, RegulatedMotor centralMotor,
            RegulatedMotor CW120degMotor, RegulatedMotor CCW120degMotor, boolean centralWheelFrontal,
            boolean motorReverse, Power battery, Gyroscope gyro) {
        this.wheelDistance = wheelDistanceFromCenter;
        this.wheelDiameter = wheelDiameter;
        this.battery = battery;
        this.gyro = gyro;
        this.wheels = new OmniWheels(new RegulatedMotor[] {centralMotor, CCW120degMotor, CW120degMotor},
                wheelDistanceFromCenter, wheelDiameter, centralWheelFrontal, motorReverse);
        this.watch = new MoveWatch(this, new OmniDrive());
    }

    /** Sets the motors' acceleration in <b>degrees</b> per second squared; fractions are dropped. */
    @Override
    public void setLinearAcceleration(double acceleration) {
        linearAcceleration = acceleration;
        wheels.setAcceleration((int) acceleration);
    }

    @Override
    public double getLinearAcceleration() {
        return linearAcceleration;
    }

    @Override
    public synchronized void forward() {
        runWithoutEnd(signed(linearSpeed), 0, direction);
    }

    @Override
    public synchronized void backward() {
        runWithoutEnd(-signed(linearSpeed), 0, direction);
    }

    /** Begins to drive in a direction, without turning and without end. */
    public synchronized void moveStraight(float linSpeed, int direction) {
        runWithoutEnd(linSpeed, 0, direction);
    }

    /** Begins to drive in a direction of the room, in degrees from where the robot looks now, while turning. */
    public synchronized void spinningMove(float linSpeed, int angSpeed, int direction) {
        double start = heading();
        WatchedMove move = runWithoutEnd(linSpeed, angSpeed, direction);
        Thread guide = new Thread(() -> {
            while (!move.isOver()) {
                Delay.msDelay(ODOMETER_MILLIS);
                guide(move, speed(linSpeed, angSpeed, direction - (heading() - start)));
            }
        }, "omni pilot odometer");
        guide.setDaemon(true);
        guide.start();
    }

    private synchronized void guide(WatchedMove move, OmniWheels.Motion speed) {
        if (!move.isOver() && !move.isReleased()) {
            wheels.run(speed);
        }
    }

    private double heading() {
        return gyro == null ? wheels.totalTurnDegrees() : gyro.getAngle();
    }

    /** Stops; returns at rest, when the listeners have heard of it. */
    @Override
    public synchronized void stop() {
        watch.releasePresent();
        wheels.halt();
        while (wheels.isMoving()) {
            Delay.msDelay(1);
        }
        watch.end(true);
    }

    @Override
    public boolean isMoving() {
        return wheels.isMoving();
    }

    /** {@inheritDoc} With a negative speed forward is backward. */
    @Override
    public void setLinearSpeed(double speed) {
        linearSpeed = Math.abs(speed);
        backward = speed < 0;
    }

    @Override
    public double getLinearSpeed() {
        return linearSpeed;
    }

    /** Sets the direction in which the robot drives forward. */
    public void setMoveDirection(int dir) {
        direction = dir;
    }

    /** The direction in which the robot drives forward. */
    public float getMoveDirection() {
        return direction;
    }

    /** {@inheritDoc} Straight ahead: there the wheels turn slower than they would in their own direction. */
    @Override
    public double getMaxLinearSpeed() {
        double rim = StrictMath.toRadians(battery.getVoltage() * DEGREES_PER_SECOND_PER_VOLT) * wheelDiameter / 2;
        return rim * 2 / StrictMath.sqrt(3);
    }

    @Override
    public void setAngularSpeed(double speed) {
        angularSpeed = speed;
    }

    @Override
    public double getAngularSpeed() {
        return angularSpeed;
    }

    @Override
    public double getMaxAngularSpeed() {
        return battery.getVoltage() * DEGREES_PER_SECOND_PER_VOLT * wheelDiameter / (2 * wheelDistance);
    }

    @Override
    public void travel(double distance) {
        travel(distance, direction, false);
    }

    /** Drives a distance in a direction and returns when done. */
    public void travel(double distance, double direction) {
        travel(distance, direction, false);
    }

    @Override
    public void travel(double distance, boolean immediateReturn) {
        travel(distance, direction, immediateReturn);
    }

    /** Drives a distance in a direction; returns at once if so told, else when done. */
    public void travel(double distance, double direction, boolean immediateReturn) {
        if (Double.isInfinite(distance)) {
            runWithoutEnd(Math.signum(distance) * signed(linearSpeed), 0, direction);
            return;
        }
        move(Move.MoveType.TRAVEL, signed(distance), 0, direction, Math.abs(distance) / linearSpeed, immediateReturn);
    }

    @Override
    public void rotate(double angle) {
        rotate(angle, false);
    }

    /** {@inheritDoc} If no angular speed was set, it becomes 90 degrees per second. */
    @Override
    public void rotate(double angle, boolean immediateReturn) {
        if (angularSpeed == 0) {
            angularSpeed = DEFAULT_ANGULAR_SPEED;
        }
        if (Double.isInfinite(angle)) {
            runWithoutEnd(0, Math.signum(angle) * angularSpeed, 0);
            return;
        }
        move(Move.MoveType.ROTATE, 0, angle, 0, Math.abs(angle / angularSpeed), immediateReturn);
    }

    /** Begins to drive along a curve: −200 to 200 percent of half the highest speed of turning. */
    public void steer(float turnRate) {
        runWithoutEnd(signed(linearSpeed), steeringSpeed(turnRate), direction);
    }

    /** Drives along a curve until the heading has changed by an angle, and returns. */
    public void steer(float turnRate, float angle) {
        steer(turnRate, angle, false);
    }

    /** Drives along a curve until the heading has changed by an angle; returns at once if so told, else when done. */
    public void steer(float turnRate, float angle, boolean immediateReturn) {
        double speed = Math.abs(steeringSpeed(turnRate));
        if (speed == 0 || angle == 0) {
            return;
        }
        double seconds = Math.abs(angle) / speed;
        move(Move.MoveType.ARC, signed(linearSpeed) * seconds, angle, direction, seconds, immediateReturn);
    }

    private double steeringSpeed(float turnRate) {
        return turnRate * getMaxAngularSpeed() / FULL_RATE;
    }

    @Override
    public void travelArc(double radius, double distance) {
        travelArc(radius, distance, direction, false);
    }

    @Override
    public void travelArc(double radius, double distance, boolean immediateReturn) {
        travelArc(radius, distance, direction, immediateReturn);
    }

    /** Drives a distance along an arc that begins in a direction, and returns when done. */
    public void travelArc(double radius, double distance, float direction) {
        travelArc(radius, distance, direction, false);
    }

    /** Drives a distance along an arc that begins in a direction; returns at once if so told, else when done. */
    public void travelArc(double radius, double distance, float direction, boolean immediateReturn) {
        if (Double.isInfinite(radius)) {
            travel(distance, (double) direction, immediateReturn);
        } else {
            arc(radius, StrictMath.toDegrees(distance / radius), (double) direction, immediateReturn);
        }
    }

    @Override
    public void arc(double radius, double angle) {
        arc(radius, angle, direction, false);
    }

    /** Drives along an arc that begins in a direction, and returns when done. */
    public void arc(double radius, double angle, double direction) {
        arc(radius, angle, direction, false);
    }

    @Override
    public void arc(double radius, double angle, boolean immediateReturn) {
        arc(radius, angle, direction, immediateReturn);
    }

    /** Drives along an arc that begins in a direction; returns at once if so told, else when done. */
    public void arc(double radius, double angle, double direction, boolean immediateReturn) {
        if (radius == 0) {
            rotate(angle, immediateReturn);
            return;
        }
        double distance = StrictMath.toRadians(angle) * radius;
        if (Double.isInfinite(distance)) {
            double speed = Math.signum(distance) * linearSpeed;
            runWithoutEnd(speed, StrictMath.toDegrees(speed / radius), direction);
            return;
        }
        move(Move.MoveType.ARC, distance, angle, direction, Math.abs(distance) / linearSpeed, immediateReturn);
    }

    /** Makes the motors' counts begin at zero, and the gyro, if there is one. */
    public void reset() {
        wheels.resetTachos();
        wheels.rebase();
        if (gyro != null) {
            gyro.reset();
        }
    }

    /** The same as {@link #setLinearSpeed}. */
    public void setSpeed(int speed) {
        setLinearSpeed(speed);
    }

    @Override
    public void arcBackward(double radius) {
        arc(radius, radius < 0 ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY, true);
    }

    @Override
    public void arcForward(double radius) {
        arc(radius, radius < 0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY, true);
    }

    @Override
    public double getMinRadius() {
        return minRadius;
    }

    /** {@inheritDoc} The pilot itself drives any arc. */
    @Override
    public void setMinRadius(double radius) {
        minRadius = radius;
    }

    @Override
    public void addMoveListener(MoveListener listener) {
        watch.addListener(listener);
    }

    /** What was done so far of the move in progress; a move of type STOP if there is none. */
    @Override
    public Move getMovement() {
        return watch.progress();
    }

    /** Does nothing: the pilot looks at its motors itself. */
    @Override
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {}

    /** Does nothing: the pilot looks at its motors itself. */
    @Override
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {}

    @Override
    public void rotateRight() {
        rotate(Double.NEGATIVE_INFINITY, true);
    }

    @Override
    public void rotateLeft() {
        rotate(Double.POSITIVE_INFINITY, true);
    }

    /** Does nothing. */
    @Override
    public void setAngularAcceleration(double acceleration) {}

    /** Always 0. */
    @Override
    public double getAngularAcceleration() {
        return 0;
    }

    private double signed(double value) {
        return backward ? -value : value;
    }

    private static OmniWheels.Motion speed(double linear, double angularDegrees, double direction) {
        double radians = StrictMath.toRadians(direction);
        return new OmniWheels.Motion(linear * StrictMath.cos(radians), linear * StrictMath.sin(radians),
                StrictMath.toRadians(angularDegrees));
    }

    private synchronized WatchedMove runWithoutEnd(double linear, double angular, double direction) {
        Move.MoveType turning = linear == 0 ? Move.MoveType.ROTATE : Move.MoveType.ARC;
        Move.MoveType kind = angular == 0 ? Move.MoveType.TRAVEL : turning;
        double distance = linear == 0 ? 0 : Math.signum(linear) * Double.POSITIVE_INFINITY;
        double angle = angular == 0 ? 0 : Math.signum(angular) * Double.POSITIVE_INFINITY;
        return begin(kind, distance, angle, () -> wheels.run(speed(linear, angular, direction)));
    }

    private void move(Move.MoveType kind, double distance, double angle, double direction, double seconds,
            boolean immediateReturn) {
        OmniWheels.Motion motion = speed(distance, angle, direction);
        WatchedMove move = begin(kind, distance, angle, () -> wheels.move(motion, Math.max(seconds, 1e-3)));
        if (!immediateReturn) {
            watch.await(move);
        }
    }

    private WatchedMove begin(Move.MoveType kind, double distance, double angle, Runnable motion) {
        watch.end(false);
        Move plan = new Move(kind, (float) distance, (float) angle, (float) linearSpeed, (float) angularSpeed, false);
        WatchedMove move = watch.begin(plan, false);
        type = kind;
        wheels.rebase();
        watch.announce(move);
        if (!move.isOver()) {
            motion.run();
            watch.follow(move);
        }
        return move;
    }

    /** The wheels as the watch sees them. */
    private final class OmniDrive implements MoveWatch.Drive {
        @Override
        public boolean isMoving() {
            return wheels.isMoving();
        }

        @Override
        public boolean isStalled() {
            return wheels.isStalled();
        }

        @Override
        public void halt() {
            wheels.halt();
        }

        @Override
        public Move done(Move plan) {
            OmniWheels.Motion done = wheels.done();
            boolean back = done.forward() < 0 && -done.forward() > Math.abs(done.left());
            double distance = back ? -done.length() : done.length();
            return new Move(type, (float) distance, (float) StrictMath.toDegrees(done.turnRadians()),
                    (float) linearSpeed, (float) angularSpeed, wheels.isMoving());
        }
    }
}
