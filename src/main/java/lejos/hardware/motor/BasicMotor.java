package lejos.hardware.motor;

import lejos.hardware.Device;
import lejos.hardware.port.BasicMotorPort;
import lejos.robotics.DCMotor;

/** A motor driven with plain power: no ramps, no regulation. Every call takes effect at once and does not block. */
public abstract class BasicMotor extends Device implements DCMotor {
    /** Mode before the first command. */
    protected static int INVALID_MODE = -1;

    /** One of the modes of {@link BasicMotorPort}, or {@link #INVALID_MODE}. */
    protected int mode = INVALID_MODE;
    /** The port the motor is plugged into. */
    protected BasicMotorPort port;
    /** Power in percent, 0 at first. */
    protected int power;

    /** A motor without a port yet: subclasses set {@link #port}. */
    public BasicMotor() {}

    /**
     * Sets the power. A motor that runs follows at once, and so does one that has had no other command yet; after stop
     * or float the power is remembered for the next start.
     *
     * @param power percent, −100 to 100; negative reverses
     */
    @Override
    public void setPower(int power) {
        this.power = power;
        port.controlMotor(power, mode);
    }

    @Override
    public int getPower() {
        return power;
    }

    /** Applies a mode with the present power unless it is the present mode. */
    protected void updateState(int newMode) {
        if (newMode == mode) {
            return;
        }
        mode = newMode;
        port.controlMotor(power, newMode);
    }

    @Override
    public void forward() {
        updateState(BasicMotorPort.FORWARD);
    }

    @Override
    public void backward() {
        updateState(BasicMotorPort.BACKWARD);
    }

    /** Whether the last command was forward or backward, whatever the power. */
    @Override
    public boolean isMoving() {
        return mode == BasicMotorPort.FORWARD || mode == BasicMotorPort.BACKWARD;
    }

    /** Lets the motor coast. */
    @Override
    public void flt() {
        updateState(BasicMotorPort.FLOAT);
    }

    /** Brakes by shorting the terminals; the position is not held. */
    @Override
    public void stop() {
        updateState(BasicMotorPort.STOP);
    }
}
