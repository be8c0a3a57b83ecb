package lejos.robotics.chassis;

import java.util.Arrays;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;
import lejos.utility.Matrix;

/**
 * A chassis whose motions follow from where its wheels are.
 *
 * <p>With ordinary wheels, an offset is positive to the left. A chassis described with the signs exchanged turns to the
 * other side than it believes, as the robot would.
 *
 * <p>May be used by several threads. This object's lock guards the motors: commands to them go together.
 */
public class WheeledChassis implements Chassis {
    /** Attribute of the motors: angle in degrees. */
    protected static final int TACHOCOUNT = 0;
    /** Attribute of the motors: highest speed in degrees per second. */
    protected static final int MAXSPEED = 1;
    /** Attribute of the motors: speed now in degrees per second. */
    protected static final int ROTATIONSPEED = 2;

    /** A chassis with ordinary wheels, which drives and turns; at least two of them. */
    public static final int TYPE_DIFFERENTIAL = 2;
    /** A chassis with wheels of rollers, which also drives sideways; at least three of them. */
    public static final int TYPE_HOLONOMIC = 3;

    private static final double DEFAULT_SHARE = 0.5;
    private static final double HALF_TURN = 180;

    /** A turn by less than this many degrees does not make a move an arc. */
    private static final double STRAIGHT_DEGREES = 1;

    /** A way that turns the motors by less than this many degrees does not make a turn an arc. */
    private static final double TURNING_MOTOR_DEGREES = 2;

    /** Rows of {@link #forward} that belong to no wheel. */
    protected final int dummyWheels;
    /** The motors, in the order of the wheels. */
    protected final RegulatedMotor[] motor;
    /** Speed of later moves in units per second. */
    protected double linearSpeed;
    /** Speed of later turns in degrees per second. */
    protected double angularSpeed;
    /** Acceleration of later moves in units per second squared. */
    protected double linearAcceleration;
    /** Acceleration of later turns in degrees per second squared. */
    protected double angularAcceleration;
    /** Turns motion of the robot (x, y, degrees) into motion of the motors. */
    protected final Matrix forward;
    /** Turns motion of the motors into motion of the robot (x, y, degrees). */
    protected final Matrix reverse;
    /** The motor through which all are commanded together. */
    protected RegulatedMotor master;
    /** Angles of the motors when the move began. */
    protected Matrix tachoAtMoveStart;
    /** {@link #forward} without signs. */
    protected final Matrix forwardAbs;
    /** {@link #reverse} without signs. */
    protected final Matrix reverseAbs;
    /** The pose provider, if there is one yet. */
    protected Odometer odometer;

    /**
     * A chassis; its speeds and accelerations are half of what the motors can keep up now.
     *
     * @param wheels its wheels; the first one's motor commands all
     * @param dim {@link #TYPE_DIFFERENTIAL} or {@link #TYPE_HOLONOMIC}
     * @throws IllegalArgumentException if there are too few wheels
     * @throws RuntimeException if the wheels do not control the robot
     * @throws ClassCastException if a motor but the first one is not a motor of this brick
     */
    public WheeledChassis(Wheel[] wheels, int dim) {
        if (wheels.length < dim) {
            throw new IllegalArgumentException("The chassis must have at least " + dim + " motorized wheels");
        }
        motor = Arrays.stream(wheels).map(Wheel::getMotor).toArray(RegulatedMotor[]::new);
        master = motor[0];
        master.synchronizeWith(Arrays.copyOfRange(motor, 1, motor.length));
        dummyWheels = dim == TYPE_DIFFERENTIAL ? 1 : 0;
        forward = WheelFactors.stack(wheels, dummyWheels > 0);
        forwardAbs = copyAbsolute(forward);
        reverse = WheelFactors.invert(forward);
        reverseAbs = copyAbsolute(reverse);
        linearSpeed = getMaxLinearSpeed() * DEFAULT_SHARE;
        angularSpeed = getMaxAngularSpeed() * DEFAULT_SHARE;
        linearAcceleration = linearSpeed;
        angularAcceleration = angularSpeed;
        tachoAtMoveStart = getAttribute(TACHOCOUNT);
    }

    @Override
    public double getLinearSpeed() {
        return linearSpeed;
    }

    @Override
    public void setLinearSpeed(double linearSpeed) {
        this.linearSpeed = linearSpeed;
    }

    @Override
    public double getAngularSpeed() {
        return angularSpeed;
    }

    @Override
    public void setAngularSpeed(double angularSpeed) {
        this.angularSpeed = angularSpeed;
    }

    @Override
    public double getLinearAcceleration() {
        return linearAcceleration;
    }

    @Override
    public void setLinearAcceleration(double linearAcceleration) {
        this.linearAcceleration = linearAcceleration;
    }

    @Override
    public double getAngularAcceleration() {
        return angularAcceleration;
    }

    @Override
    public void setAngularAcceleration(double angularAcceleration) {
        this.angularAcceleration = angularAcceleration;
    }

    /** A copy of the matrix that turns motion of the robot into motion of the motors. */
    public Matrix getForward() {
        return forward.copy();
    }

    /** A copy of the matrix that turns motion of the motors into motion of the robot. */
    public Matrix getReverse() {
        return reverse.copy();
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless both are above 0 */
    @Override
    public void setSpeed(double linearSpeed, double angularSpeed) {
        if (linearSpeed <= 0 || angularSpeed <= 0) {
            throw new IllegalArgumentException("Speed must be greater than 0");
        }
        this.linearSpeed = linearSpeed;
        this.angularSpeed = angularSpeed;
    }

    /** {@inheritDoc} @throws IllegalArgumentException unless both are above 0 */
    @Override
    public void setAcceleration(double forwardAcceleration, double angularAcceleration) {
        if (forwardAcceleration <= 0 || angularAcceleration <= 0) {
            throw new IllegalArgumentException("Acceleration must be greater than 0");
        }
        this.linearAcceleration = forwardAcceleration;
        this.angularAcceleration = angularAcceleration;
    }

    @Override
    public boolean isMoving() {
        return Arrays.stream(motor).anyMatch(RegulatedMotor::isMoving);
    }

    @Override
    public void waitComplete() {
        for (RegulatedMotor wheel : motor) {
            wheel.waitComplete();
        }
    }

    @Override
    public boolean isStalled() {
        return Arrays.stream(motor).anyMatch(RegulatedMotor::isStalled);
    }

    @Override
    public double getMinRadius() {
        return 0;
    }

    @Override
    public void stop() {
        setVelocity(0, 0, 0);
    }

    @Override
    public void setVelocity(double linearSpeed, double angularSpeed) {
        setVelocity(linearSpeed, 0, angularSpeed);
    }

    @Override
    public void travelCartesian(double xSpeed, double ySpeed, double angularSpeed) {
        Matrix polar = toPolar(xSpeed, ySpeed, angularSpeed);
        setVelocity(polar.get(0, 0), polar.get(1, 0), angularSpeed);
    }

    /** {@inheritDoc} @throws RuntimeException if a robot with ordinary wheels is told to drive sideways */
    @Override
    public synchronized void setVelocity(double linearSpeed, double direction, double angularSpeed) {
        if (dummyWheels == 1 && direction % HALF_TURN != 0) {
            throw new RuntimeException("A differential robot cannot drive in the direction " + direction);
        }
        double radians = StrictMath.toRadians(direction);
        Matrix target = forward.times(toCartesianMatrix(linearSpeed, radians, angularSpeed));
        Matrix able = toCartesianMatrix(linearAcceleration, radians, angularAcceleration);
        Matrix change = target.minus(getAttribute(ROTATIONSPEED));
        VelocityRamp ramp = new VelocityRamp(change, forwardAbs.times(copyAbsolute(able)));
        master.startSynchronization();
        for (int i = 0; i < motor.length; i++) {
            double speed = target.get(i, 0);
            motor[i].setAcceleration(ramp.acceleration(i));
            motor[i].setSpeed((int) Math.abs(speed));
            run(motor[i], speed);
        }
        master.endSynchronization();
    }

    private static void run(RegulatedMotor wheel, double speed) {
        if (speed > 0) {
            wheel.forward();
        } else if (speed < 0) {
            wheel.backward();
        } else {
            wheel.stop();
        }
    }

    @Override
    public void travel(double distance) {
        if (Double.isInfinite(distance)) {
            setVelocity(Math.signum(distance) * linearSpeed, 0);
            return;
        }
        setMotors(forward.times(toMatrix(distance, 0, 0)), forwardAbs.times(toMatrix(linearSpeed, 0, 0)),
                forwardAbs.times(toMatrix(linearAcceleration, 0, 0)));
    }

    @Override
    public void rotate(double angle) {
        if (Double.isInfinite(angle)) {
            setVelocity(0, Math.signum(angle) * angularSpeed);
            return;
        }
        setMotors(forward.times(toMatrix(0, 0, angle)), forwardAbs.times(toMatrix(0, 0, angularSpeed)),
                forwardAbs.times(toMatrix(0, 0, angularAcceleration)));
    }

    @Override
    public void arc(double radius, double angle) {
        if (angle == 0) {
            return;
        }
        if (radius == 0) {
            rotate(angle);
        } else if (Double.isInfinite(radius)) {
            travel(Math.signum(angle) * Double.POSITIVE_INFINITY);
        } else if (Double.isInfinite(angle)) {
            ArcPace speed = ArcPace.within(linearSpeed, angularSpeed, radius);
            double direction = Math.signum(angle);
            setVelocity(direction * speed.linear(), direction * Math.signum(radius) * speed.angular());
        } else {
            finiteArc(radius, angle);
        }
    }

    /** The wheel with the longest way sets the pace, so that all arrive together. */
    private void finiteArc(double radius, double angle) {
        double distance = StrictMath.toRadians(angle) * Math.abs(radius);
        Matrix displacement = forward.times(toMatrix(distance, 0, Math.signum(radius) * angle));
        Matrix ratios = copyAbsolute(displacement).timesEquals(1 / getMax(displacement));
        ArcPace speed = ArcPace.within(linearSpeed, angularSpeed, radius);
        ArcPace acceleration = ArcPace.within(linearAcceleration, angularAcceleration, radius);
        setMotors(displacement, ratios.times(fastest(speed)), ratios.times(fastest(acceleration)));
    }

    private double fastest(ArcPace pace) {
        return getMax(forwardAbs.times(toMatrix(pace.linear(), 0, pace.angular())));
    }

    /** Begins to turn the motors by angles, all together; each row is a motor's. Fractions are dropped. */
    protected synchronized void setMotors(Matrix motorDelta, Matrix motorSpeed, Matrix motorAcceleration) {
        master.startSynchronization();
        for (int i = 0; i < motor.length; i++) {
            motor[i].setAcceleration((int) motorAcceleration.get(i, 0));
            motor[i].setSpeed((int) motorSpeed.get(i, 0));
            motor[i].rotate((int) motorDelta.get(i, 0));
        }
        master.endSynchronization();
    }

    @Override
    public double getMaxLinearSpeed() {
        Matrix fastest = reverseAbs.times(getAttribute(MAXSPEED));
        return length(fastest.get(0, 0), fastest.get(1, 0));
    }

    @Override
    public double getMaxAngularSpeed() {
        return reverseAbs.times(getAttribute(MAXSPEED)).get(2, 0);
    }

    @Override
    public Matrix getCurrentSpeed() {
        Matrix speed = reverse.times(getAttribute(ROTATIONSPEED));
        return toPolar(speed.get(0, 0), speed.get(1, 0), speed.get(2, 0));
    }

    @Override
    public double getLinearVelocity() {
        return getCurrentSpeed().get(0, 0);
    }

    @Override
    public double getLinearDirection() {
        return getCurrentSpeed().get(1, 0);
    }

    @Override
    public double getAngularVelocity() {
        return getCurrentSpeed().get(2, 0);
    }

    @Override
    public void moveStart() {
        tachoAtMoveStart = getAttribute(TACHOCOUNT);
    }

    /** {@inheritDoc} The distance is negative after driving mainly backward. */
    @Override
    public Move getDisplacement(Move move) {
        Matrix moved = reverse.times(getAttribute(TACHOCOUNT).minus(tachoAtMoveStart));
        double x = moved.get(0, 0);
        double y = moved.get(1, 0);
        double rotation = moved.get(2, 0);
        double distance = x < 0 && -x > Math.abs(y) ? -length(x, y) : length(x, y);
        move.setValues(typeOf(distance, rotation), (float) distance, (float) rotation, isMoving());
        return move;
    }

    private Move.MoveType typeOf(double distance, double rotation) {
        if (distance == 0 && rotation == 0) {
            return Move.MoveType.STOP;
        }
        if (Math.abs(rotation) < STRAIGHT_DEGREES) {
            return Move.MoveType.TRAVEL;
        }
        double motorDegrees = Math.abs(distance) * getMax(forwardAbs.getMatrix(0, motor.length - 1, 0, 1));
        return motorDegrees < TURNING_MOTOR_DEGREES ? Move.MoveType.ROTATE : Move.MoveType.ARC;
    }

    /** Begins the description of a wheel with rollers. */
    public static HolonomicModeler modelHolonomicWheel(RegulatedMotor motor, double diameter) {
        return new HolonomicModeler(motor, diameter);
    }

    /** Begins the description of an ordinary wheel. */
    public static Modeler modelWheel(RegulatedMotor motor, double diameter) {
        return new Modeler(motor, diameter);
    }

    @Override
    public synchronized PoseProvider getPoseProvider() {
        if (odometer == null) {
            odometer = new Odometer();
            odometer.start();
        }
        return odometer;
    }

    /** One column. */
    protected Matrix toMatrix(double x, double y, double a) {
        return new Matrix(new double[] {x, y, a}, 3);
    }

    /** One column: x, y and the angle, of a length in a direction in radians. */
    protected Matrix toCartesianMatrix(double length, double radians, double a) {
        return toMatrix(length * StrictMath.cos(radians), length * StrictMath.sin(radians), a);
    }

    /** One column: length, direction in degrees and the angle, of a vector. */
    protected Matrix toPolar(double x, double y, double a) {
        return toMatrix(length(x, y), StrictMath.toDegrees(StrictMath.atan2(y, x)), a);
    }

    /** One column with an attribute of all motors, and 0 for rows without one. */
    protected synchronized Matrix getAttribute(int attribute) {
        Matrix column = new Matrix(motor.length + dummyWheels, 1);
        for (int i = 0; i < motor.length; i++) {
            column.set(i, 0, attribute(motor[i], attribute));
        }
        return column;
    }

    private static double attribute(RegulatedMotor wheel, int attribute) {
        return switch (attribute) {
            case TACHOCOUNT -> wheel.getTachoCount();
            case MAXSPEED -> wheel.getMaxSpeed();
            case ROTATIONSPEED -> wheel.getRotationSpeed();
            default -> 0;
        };
    }

    /** The greatest number, signs left aside. */
    protected double getMax(Matrix matrix) {
        return Arrays.stream(matrix.getRowPackedCopy()).map(Math::abs).max().orElse(0);
    }

    /** A copy without signs. */
    protected Matrix copyAbsolute(Matrix matrix) {
        double[][] values = matrix.getArrayCopy();
        for (double[] row : values) {
            Arrays.setAll(row, i -> Math.abs(row[i]));
        }
        return new Matrix(values);
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    /** The pose by the wheels of this chassis. */
    class Odometer extends WheelOdometer {
        Odometer() {
            super(() -> getAttribute(TACHOCOUNT), reverse);
        }
    }

    /** Describes an ordinary wheel. */
    public static class Modeler implements Wheel {
        /** Drives the wheel. */
        protected RegulatedMotor motor;
        /** Diameter of the wheel. */
        protected double diameter;
        /** Turns of the motor per turn of the wheel. */
        protected double gearRatio = 1;
        /** Distance from the middle of the robot, positive to the left. */
        protected double offset;
        /** Not used. */
        protected double angle;
        /** Whether the wheel turns the other way than its motor. */
        protected boolean invert;

        /** A wheel in the middle of the robot. */
        public Modeler(RegulatedMotor motor, double diameter) {
            this.motor = motor;
            this.diameter = diameter;
        }

        /** Sets the distance from the middle of the robot, positive to the left. */
        public Modeler offset(double val) {
            offset = val;
            return this;
        }

        /** Sets the turns of the motor per turn of the wheel. */
        public Modeler gearRatio(double val) {
            gearRatio = val;
            return this;
        }

        /** Says whether the wheel turns the other way than its motor. */
        public Modeler invert(boolean val) {
            invert = val;
            return this;
        }

        @Override
        public Matrix getFactors() {
            return WheelFactors.differential(diameter, gearRatio, offset, invert);
        }

        @Override
        public RegulatedMotor getMotor() {
            return motor;
        }
    }

    /** Describes a wheel with rollers. */
    public static class HolonomicModeler implements Wheel {
        private static final float QUARTER_TURN = 90;

        /** Drives the wheel. */
        protected RegulatedMotor motor;
        /** Diameter of the wheel. */
        protected double diameter;
        /** Turns of the wheel per turn of the motor. */
        protected double gearRatio = 1;
        /** Not used. */
        protected double offset;
        /** Where the wheel is, and in which direction it drives. */
        protected Pose pose = new Pose(0, 0, 0);
        /** Whether the wheel turns the other way than its motor. */
        protected boolean invert;

        /** A wheel in the middle of the robot that drives straight ahead. */
        public HolonomicModeler(RegulatedMotor motor, double diameter) {
            this.motor = motor;
            this.diameter = diameter;
        }

        /** Puts the wheel in a direction in degrees, at a distance; it drives counter-clockwise around the middle. */
        public HolonomicModeler polarPosition(double angle, double radius) {
            pose = new Pose(0, 0, (float) angle);
            pose.moveUpdate((float) radius);
            pose.rotateUpdate(QUARTER_TURN);
            return this;
        }

        /** Puts the wheel somewhere; it drives in a direction in degrees. */
        public HolonomicModeler cartesianPosition(double x, double y, double angle) {
            pose = new Pose((float) x, (float) y, (float) angle);
            return this;
        }

        /** Sets the turns of the wheel per turn of the motor. */
        public HolonomicModeler gearRatio(double val) {
            gearRatio = val;
            return this;
        }

        /** Says whether the wheel turns the other way than its motor. */
        public HolonomicModeler invert(boolean val) {
            invert = val;
            return this;
        }

        @Override
        public Matrix getFactors() {
            return WheelFactors.holonomic(diameter, gearRatio, pose, invert);
        }

        @Override
        public RegulatedMotor getMotor() {
            return motor;
        }
    }
}
