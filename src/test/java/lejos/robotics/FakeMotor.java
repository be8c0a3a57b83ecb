package lejos.robotics;

import java.util.ArrayList;
import java.util.List;

/** A motor that obeys at once: a turn by an angle is done when it is told, a turn without end goes on until told. */
public final class FakeMotor implements RegulatedMotor {
    private static final float MAX_SPEED = 900;

    private final List<String> commands = new ArrayList<>();
    private volatile int tacho;
    private volatile int rotationSpeed;
    private volatile int speed;
    private volatile int acceleration;
    private volatile boolean moving;
    private volatile boolean stalled;
    private volatile boolean slow;
    private volatile RegulatedMotorListener listener;

    /** Where the motor is. */
    public void setTacho(int degrees) {
        tacho = degrees;
    }

    /** What the motor says of its speed. */
    public void setRotationSpeed(int degreesPerSecond) {
        rotationSpeed = degreesPerSecond;
    }

    /** From now on a turn by an angle counts as moving until {@link #finish}. */
    public void setSlow() {
        slow = true;
    }

    /** Ends a motion. */
    public void finish() {
        run(false);
    }

    /** Ends a motion because the motor is stuck. */
    public void stall() {
        stalled = true;
        run(false);
    }

    private void run(boolean yes) {
        boolean before = moving;
        moving = yes;
        RegulatedMotorListener heard = listener;
        if (heard != null && yes && !before) {
            heard.rotationStarted(this, tacho, false, 0);
        } else if (heard != null && !yes && before) {
            heard.rotationStopped(this, tacho, stalled, 0);
        }
    }

    /** Acceleration and speed, and the motion: "450, 450, rotate 204". */
    public synchronized String lastCommand() {
        return commands.isEmpty() ? "nothing" : commands.get(commands.size() - 1);
    }

    /** All motions commanded, the last one last. */
    public synchronized List<String> commands() {
        return new ArrayList<>(commands);
    }

    /** Forgets the commands. */
    public synchronized void forget() {
        commands.clear();
    }

    private synchronized void note(String motion) {
        stalled = false;
        commands.add(acceleration + ", " + speed + ", " + motion);
    }

    @Override
    public void forward() {
        note("forward");
        run(true);
    }

    @Override
    public void backward() {
        note("backward");
        run(true);
    }

    @Override
    public void rotate(int angle, boolean immediateReturn) {
        note("rotate " + angle);
        run(true);
        tacho += angle;
        run(slow);
    }

    @Override
    public void stop(boolean immediateReturn) {
        note("stop");
        run(false);
    }

    @Override
    public void setSpeed(int speed) {
        this.speed = Math.abs(speed);
    }

    @Override
    public void setAcceleration(int acceleration) {
        this.acceleration = Math.abs(acceleration);
    }

    @Override
    public int getSpeed() {
        return speed;
    }

    @Override
    public float getMaxSpeed() {
        return MAX_SPEED;
    }

    @Override
    public int getTachoCount() {
        return tacho;
    }

    @Override
    public void resetTachoCount() {
        tacho = 0;
    }

    @Override
    public int getRotationSpeed() {
        return rotationSpeed;
    }

    @Override
    public boolean isMoving() {
        return moving;
    }

    @Override
    public boolean isStalled() {
        return stalled;
    }

    @Override
    public int getLimitAngle() {
        return tacho;
    }

    @Override
    public void rotate(int angle) {
        rotate(angle, false);
    }

    @Override
    public void rotateTo(int limitAngle) {
        rotate(limitAngle - tacho, false);
    }

    @Override
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        rotate(limitAngle - tacho, immediateReturn);
    }

    @Override
    public void stop() {
        stop(false);
    }

    @Override
    public void flt() {
        stop(false);
    }

    @Override
    public void flt(boolean immediateReturn) {
        stop(immediateReturn);
    }

    @Override
    public void waitComplete() {
        run(false);
    }

    @Override
    public void addListener(RegulatedMotorListener listener) {
        this.listener = listener;
    }

    @Override
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener before = listener;
        listener = null;
        return before;
    }

    @Override
    public void setStallThreshold(int error, int time) {}

    @Override
    public void synchronizeWith(RegulatedMotor[] syncList) {}

    @Override
    public void startSynchronization() {}

    @Override
    public void endSynchronization() {}

    @Override
    public void close() {}
}
