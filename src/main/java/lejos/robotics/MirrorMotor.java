package lejos.robotics;

import java.util.Arrays;

/**
 * A regulated motor seen from the other side: forward is backward.
 *
 * <p>It takes the place of the motor's one listener and passes events on to its own. Settings such as speed and
 * acceleration have no direction and pass unchanged.
 */
public class MirrorMotor implements RegulatedMotor, RegulatedMotorListener {
    private final RegulatedMotor motor;
    private RegulatedMotorListener listener;

    private MirrorMotor(RegulatedMotor motor) {
        this.motor = motor;
        listener = motor.removeListener();
        motor.addListener(this);
    }

    /**
     * The motor with its directions exchanged.
     *
     * @return a new mirror, or the original of a mirror, which gets its listener back
     */
    public static RegulatedMotor invertMotor(RegulatedMotor motor) {
        if (motor instanceof MirrorMotor mirror) {
            return mirror.unwrap();
        }
        return new MirrorMotor(motor);
    }

    /**
     * The motor with its directions exchanged.
     *
     * @return a new mirror, or the original of a mirror
     */
    public static EncoderMotor invertMotor(EncoderMotor motor) {
        return motor instanceof ReversedEncoderMotor reversed ? reversed.original() : new ReversedEncoderMotor(motor);
    }

    private RegulatedMotor unwrap() {
        motor.removeListener();
        if (listener != null) {
            motor.addListener(listener);
        }
        return motor;
    }

    @Override
    public void addListener(RegulatedMotorListener listener) {
        motor.addListener(this);
        this.listener = listener;
    }

    @Override
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener removed = listener;
        listener = null;
        motor.removeListener();
        return removed;
    }

    @Override
    public void flt(boolean immediateReturn) {
        motor.flt(immediateReturn);
    }

    @Override
    public int getLimitAngle() {
        return -motor.getLimitAngle();
    }

    @Override
    public float getMaxSpeed() {
        return motor.getMaxSpeed();
    }

    @Override
    public int getSpeed() {
        return motor.getSpeed();
    }

    @Override
    public boolean isStalled() {
        return motor.isStalled();
    }

    @Override
    public void rotate(int angle) {
        motor.rotate(-angle);
    }

    @Override
    public void rotate(int angle, boolean immediateReturn) {
        motor.rotate(-angle, immediateReturn);
    }

    @Override
    public void rotateTo(int limitAngle) {
        motor.rotateTo(-limitAngle);
    }

    @Override
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        motor.rotateTo(-limitAngle, immediateReturn);
    }

    @Override
    public void setAcceleration(int acceleration) {
        motor.setAcceleration(acceleration);
    }

    @Override
    public void setSpeed(int speed) {
        motor.setSpeed(speed);
    }

    @Override
    public void setStallThreshold(int error, int time) {
        motor.setStallThreshold(error, time);
    }

    @Override
    public void stop(boolean immediateReturn) {
        motor.stop(immediateReturn);
    }

    @Override
    public void waitComplete() {
        motor.waitComplete();
    }

    @Override
    public void backward() {
        motor.forward();
    }

    @Override
    public void flt() {
        motor.flt();
    }

    @Override
    public void forward() {
        motor.backward();
    }

    @Override
    public boolean isMoving() {
        return motor.isMoving();
    }

    @Override
    public void stop() {
        motor.stop();
    }

    @Override
    public int getRotationSpeed() {
        return -motor.getRotationSpeed();
    }

    @Override
    public int getTachoCount() {
        return -motor.getTachoCount();
    }

    @Override
    public void resetTachoCount() {
        motor.resetTachoCount();
    }

    /** Passes the event on with this mirror's view of it. */
    @Override
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        if (listener != null) {
            listener.rotationStarted(this, -tachoCount, stalled, timeStamp);
        }
    }

    /** Passes the event on with this mirror's view of it. */
    @Override
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        if (listener != null) {
            listener.rotationStopped(this, -tachoCount, stalled, timeStamp);
        }
    }

    @Override
    public void close() {
        motor.close();
    }

    /** Synchronises the motor with others, of which mirrors may be some. */
    @Override
    public void synchronizeWith(RegulatedMotor[] syncList) {
        motor.synchronizeWith(Arrays.stream(syncList).map(MirrorMotor::original).toArray(RegulatedMotor[]::new));
    }

    @Override
    public void startSynchronization() {
        motor.startSynchronization();
    }

    @Override
    public void endSynchronization() {
        motor.endSynchronization();
    }

    private static RegulatedMotor original(RegulatedMotor motor) {
        return motor instanceof MirrorMotor mirror ? mirror.motor : motor;
    }
}
