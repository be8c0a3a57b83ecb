package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * Drives a robot that steers like a car, with three positions of the wheel: straight ahead, and as far as it goes to
 * the left and to the right. So an arc of any radius is driven with the least one, as long as it would have been.
 *
 * <p>The speed is that of the drive motor.
 */
public class SteeringPilot implements ArcMoveController, RegulatedMotorListener {
    private static final double FULL_TURN = 360;
    private static final double RADIUS_SLACK = 0.1;
    private static final int CALIBRATION_SPEED = 100;
    private static final int CALIBRATION_STALL_DEGREES = 10;
    private static final int CALIBRATION_STALL_MILLIS = 100;
    private static final int STALL_DEGREES = 50;
    private static final int STALL_MILLIS = 1000;

    private final double degPerDistance;
    private final RegulatedMotor drive;
    private final RegulatedMotor steering;
    private final MoveWatch watch;
    private volatile double minTurnRadius;
    private volatile int leftTacho;
    private volatile int rightTacho;
    private volatile double radius = Double.POSITIVE_INFINITY;
    private volatile int tachoAtStart;

    /**
     * A pilot.
     *
     * @param driveWheelDiameter diameter of the driven wheel
     * @param driveMotor its motor
     * @param steeringMotor motor that steers; 0 is straight ahead
     * @param minTurnRadius radius of the arc with the steering as far as it goes
     * @param leftTurnTacho position of the steering motor as far left as it goes
     * @param rightTurnTacho position of the steering motor as far right as it goes
     */
    public SteeringPilot(double driveWheelDiameter, RegulatedMotor driveMotor, RegulatedMotor steeringMotor,
            double minTurnRadius, int leftTurnTacho, int rightTurnTacho) {
        this.degPerDistance = FULL_TURN / (Math.PI * driveWheelDiameter);
        this.drive = driveMotor;
        this.steering = steeringMotor;
        this.minTurnRadius = minTurnRadius;
        this.leftTacho = leftTurnTacho;
        this.rightTacho = rightTurnTacho;
        this.watch = new MoveWatch(this, new CarDrive());
    }

    /** Steers to both ends, by feeling where they are, and takes the middle as straight ahead. */
    public void calibrateSteering() {
        steering.setSpeed(CALIBRATION_SPEED);
        steering.setStallThreshold(CALIBRATION_STALL_DEGREES, CALIBRATION_STALL_MILLIS);
        steering.forward();
        int right = tachoAtEnd();
        steering.backward();
        int left = tachoAtEnd();
        int center = (left + right) / 2;
        rightTacho = right - center;
        leftTacho = left - center;
        steering.rotateTo(center);
        steering.resetTachoCount();
        steering.setStallThreshold(STALL_DEGREES, STALL_MILLIS);
    }

    private int tachoAtEnd() {
        steering.waitComplete();
        return steering.getTachoCount();
    }

    @Override
    public double getMinRadius() {
        return minTurnRadius;
    }

    @Override
    public void setMinRadius(double radius) {
        minTurnRadius = radius;
    }

    @Override
    public void arcForward(double turnRadius) {
        travelArc(turnRadius, Double.POSITIVE_INFINITY, true);
    }

    @Override
    public void arcBackward(double turnRadius) {
        travelArc(turnRadius, Double.NEGATIVE_INFINITY, true);
    }

    /** {@inheritDoc} @throws IllegalArgumentException if the radius is less than the least */
    @Override
    public void arc(double turnRadius, double arcAngle) throws IllegalArgumentException {
        arc(turnRadius, arcAngle, false);
    }

    /** {@inheritDoc} The angle is the change of heading on the circle asked for. */
    @Override
    public void arc(double turnRadius, double arcAngle, boolean immediateReturn) {
        requireRadius(turnRadius);
        travelArc(turnRadius, StrictMath.toRadians(arcAngle) * turnRadius, immediateReturn);
    }

    @Override
    public void travelArc(double turnRadius, double distance) {
        travelArc(turnRadius, distance, false);
    }

    /** {@inheritDoc} @throws IllegalArgumentException if the radius is less than the least */
    @Override
    public void travelArc(double turnRadius, double distance, boolean immediateReturn) throws IllegalArgumentException {
        requireRadius(turnRadius);
        watch.end(false);
        steer(turnRadius);
        WatchedMove move = watch.begin(plan(distance), false);
        tachoAtStart = drive.getTachoCount();
        drive(distance);
        watch.announce(move);
        watch.follow(move);
        if (!immediateReturn) {
            watch.await(move);
        }
    }

    private void requireRadius(double turnRadius) {
        if (Math.abs(turnRadius) < minTurnRadius - RADIUS_SLACK) {
            throw new IllegalArgumentException("The radius must be at least " + minTurnRadius);
        }
    }

    private void steer(double turnRadius) {
        if (Double.isInfinite(turnRadius)) {
            steering.rotateTo(0);
            radius = Double.POSITIVE_INFINITY;
        } else {
            steering.rotateTo(turnRadius > 0 ? leftTacho : rightTacho);
            radius = turnRadius > 0 ? minTurnRadius : -minTurnRadius;
        }
    }

    private void drive(double distance) {
        if (distance == Double.POSITIVE_INFINITY) {
            drive.forward();
        } else if (distance == Double.NEGATIVE_INFINITY) {
            drive.backward();
        } else {
            drive.rotate((int) (distance * degPerDistance), true);
        }
    }

    private Move plan(double distance) {
        return move(distance, false);
    }

    private Move move(double distance, boolean moving) {
        if (Double.isInfinite(radius)) {
            return new Move(Move.MoveType.TRAVEL, (float) distance, 0, moving);
        }
        return new Move(Move.MoveType.ARC, (float) distance, (float) StrictMath.toDegrees(distance / radius), moving);
    }

    private double travelled() {
        return (drive.getTachoCount() - tachoAtStart) / degPerDistance;
    }

    @Override
    public void backward() {
        travel(Double.NEGATIVE_INFINITY, true);
    }

    @Override
    public void forward() {
        travel(Double.POSITIVE_INFINITY, true);
    }

    /** Always 0. */
    @Override
    public double getMaxLinearSpeed() {
        return 0;
    }

    /** Always 0: the speed is the drive motor's. */
    @Override
    public double getLinearSpeed() {
        return 0;
    }

    /** Always 0; see {@link #getMovement}. */
    public float getMovementIncrement() {
        return 0;
    }

    @Override
    public boolean isMoving() {
        return drive.isMoving();
    }

    /** Does nothing: the speed is the drive motor's. */
    @Override
    public void setLinearSpeed(double speed) {}

    /** Stops; returns at rest, when the listeners have heard of it. */
    @Override
    public void stop() {
        drive.stop();
        watch.end(true);
    }

    @Override
    public void travel(double distance) {
        travel(distance, false);
    }

    @Override
    public void travel(double distance, boolean immediateReturn) {
        travelArc(Double.POSITIVE_INFINITY, distance, immediateReturn);
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

    /** Does nothing: the pilot looks at its motor itself. */
    @Override
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {}

    /** Does nothing: the pilot looks at its motor itself. */
    @Override
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {}

    /** Does nothing: the acceleration is the drive motor's. */
    @Override
    public void setLinearAcceleration(double acceleration) {}

    /** Always 0: the acceleration is the drive motor's. */
    @Override
    public double getLinearAcceleration() {
        return 0;
    }

    /** The drive motor as the watch sees it. */
    private final class CarDrive implements MoveWatch.Drive {
        @Override
        public boolean isMoving() {
            return drive.isMoving();
        }

        @Override
        public boolean isStalled() {
            return drive.isStalled();
        }

        @Override
        public void halt() {
            drive.stop(true);
        }

        @Override
        public Move done(Move plan) {
            return move(travelled(), drive.isMoving());
        }
    }
}
