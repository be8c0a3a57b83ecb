package lejos.robotics.navigation;

import lejos.robotics.DirectionFinder;
import lejos.robotics.RegulatedMotor;
import lejos.utility.Delay;

/**
 * Drives a robot with two wheels and corrects its heading with a compass.
 *
 * <p><b>The type of a number counts:</b> {@code travel(10)} and {@code rotate(90f)} take the compass, {@code
 * travel(10.0)} and {@code rotate(90.0)} are those of {@link DifferentialPilot}, which do not.
 *
 * @deprecated use {@link MovePilot} with a pose provider
 */
@Deprecated
public class CompassPilot extends DifferentialPilot {
    private static final int CORRECTION_MILLIS = 12;
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;
    private static final float STEERING_PER_DEGREE = 3;
    private static final float WORTH_STEERING_DEGREES = 2;
    private static final float ACCEPTED_DEGREES = 2;
    private static final float FINISH_DISTANCE = 3;
    private static final int MOST_CORRECTIONS = 10;
    private static final double CALIBRATION_SPEED = 50;

    /** The compass. */
    protected DirectionFinder compass;
    /** Steers while the robot travels. */
    protected Regulator regulator = new Regulator();
    /** Heading to keep, in degrees. */
    protected float _heading;
    /** What the heading probably is, in degrees. */
    protected float _estimatedHeading;
    /** Whether the robot travels with the compass. Guarded by the regulator. */
    protected boolean _traveling;
    /** Distance to travel. */
    protected float _distance;
    /** 1 forward, −1 backward. */
    protected byte _direction;
    /** Compass heading when the move began. */
    protected float _heading0;

    private float turnAtLastEstimate;

    /** A pilot; see {@link DifferentialPilot#DifferentialPilot(double, double, RegulatedMotor, RegulatedMotor)}. */
    public CompassPilot(DirectionFinder compass, float wheelDiameter, float trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor) {
        this(compass, wheelDiameter, trackWidth, leftMotor, rightMotor, false);
    }

    /** A pilot whose motors perhaps run in reverse; see the constructor above. */
    public CompassPilot(DirectionFinder compass, float wheelDiameter, float trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor, boolean reverse) {
        super(wheelDiameter, trackWidth, leftMotor, rightMotor, reverse);
        this.compass = compass;
        _estimatedHeading = getCompassHeading();
        regulator.setDaemon(true);
        regulator.start();
    }

    /** Whether the robot travels with the compass. */
    public boolean isTraveling() {
        return regulator.isOn();
    }

    /** The compass. */
    public DirectionFinder getCompass() {
        return compass;
    }

    /** Change of heading in degrees since the present or last move began, by the compass. */
    @Override
    public float getAngleIncrement() {
        return normalize(getCompassHeading() - _heading0);
    }

    @Override
    float turned(DriveWheels.Movement movement) {
        return getAngleIncrement();
    }

    @Override
    void begun() {
        _heading0 = getCompassHeading();
    }

    /** What the heading probably is, in degrees, −180 to 180. */
    public float getHeading() {
        return estimate();
    }

    /** Heading by the compass, in degrees, −180 to 180. */
    public float getCompassHeading() {
        return normalize(compass.getDegreesCartesian());
    }

    /** Sets the heading to keep, in degrees. */
    public void setHeading(float angle) {
        _heading = angle;
    }

    /** Turns once around while the compass calibrates itself. */
    public synchronized void calibrate() {
        setAngularSpeed(CALIBRATION_SPEED);
        compass.startCalibration();
        super.rotate((double) FULL_TURN, false);
        compass.stopCalibration();
    }

    /** Makes the present heading zero, and the one to keep. */
    public void resetCartesianZero() {
        compass.resetCartesianZero();
        _heading = 0;
        _estimatedHeading = 0;
    }

    /** How far the heading is off, in degrees; positive = too far to the left. */
    public float getHeadingError() {
        return normalize(estimate() - _heading);
    }

    /** Half what the compass says, half what the wheels say. */
    private synchronized float estimate() {
        float turn = totalTurn();
        float byWheels = _estimatedHeading + turn - turnAtLastEstimate;
        turnAtLastEstimate = turn;
        _estimatedHeading = normalize(byWheels + normalize(getCompassHeading() - byWheels) / 2);
        return _estimatedHeading;
    }

    /** Travels and keeps the heading; returns at once if so told, else when done. */
    public void travel(float distance, boolean immediateReturn) {
        stop();
        regulator.begin(distance);
        if (!immediateReturn) {
            regulator.await();
        }
    }

    /** Travels and keeps the heading; returns when done. */
    public void travel(float distance) {
        travel(distance, false);
    }

    /** Turns, and the heading to keep with it; if it waits for the end, corrects the heading until it is right. */
    public void rotate(float angle, boolean immediateReturn) {
        _heading = normalize(_heading + angle);
        super.rotate((double) angle, immediateReturn);
        if (immediateReturn) {
            return;
        }
        for (int i = 0; i < MOST_CORRECTIONS && Math.abs(getHeadingError()) > ACCEPTED_DEGREES; i++) {
            super.rotate((double) -getHeadingError(), false);
        }
    }

    /** Turns, and the heading to keep with it, until the heading is right. */
    public void rotate(float angle) {
        rotate(angle, false);
    }

    /** Makes increments and the motors' counts begin at zero. */
    @Override
    public void reset() {
        _left.resetTachoCount();
        _right.resetTachoCount();
        turnAtLastEstimate = 0;
        super.reset();
    }

    /** Stops. */
    protected void stopNow() {
        stop();
    }

    @Override
    public void stop() {
        regulator.end();
        super.stop();
    }

    /** The same angle from −180 to 180. */
    protected float normalize(float angle) {
        float turn = angle % FULL_TURN;
        if (turn > HALF_TURN) {
            return turn - FULL_TURN;
        }
        return turn < -HALF_TURN ? turn + FULL_TURN : turn;
    }

    /** Steers a robot that travels. */
    class Regulator extends Thread {
        private float begin;

        /** Steers whenever the robot travels. */
        @Override
        public void run() {
            while (true) {
                awaitTravel(true);
                steerToTheEnd();
            }
        }

        private synchronized void begin(float distance) {
            _distance = distance;
            _direction = (byte) (distance < 0 ? -1 : 1);
            begin = totalDistance();
            _traveling = true;
            notifyAll();
        }

        private synchronized boolean isOn() {
            return _traveling;
        }

        private synchronized void end() {
            _traveling = false;
            notifyAll();
        }

        private void await() {
            awaitTravel(false);
        }

        private synchronized void awaitTravel(boolean wanted) {
            boolean interrupted = false;
            while (_traveling != wanted) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                interrupt();
            }
        }

        private void steerToTheEnd() {
            float steeredFor = Float.NaN;
            while (isOn() && left() * _direction > FINISH_DISTANCE) {
                float error = getHeadingError();
                if (!(Math.abs(error - steeredFor) <= WORTH_STEERING_DEGREES)) {
                    steeredFor = error;
                    steerAgainst(error);
                }
                Delay.msDelay(CORRECTION_MILLIS);
            }
            if (isOn()) {
                CompassPilot.super.travel((double) left(), false);
                end();
            }
        }

        private float left() {
            return _distance - (totalDistance() - begin);
        }

        private void steerAgainst(float error) {
            double rate = -STEERING_PER_DEGREE * error * _direction;
            if (_direction > 0) {
                steer(rate);
            } else {
                steerBackward(rate);
            }
        }
    }
}
