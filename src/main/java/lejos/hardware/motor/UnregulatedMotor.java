package lejos.hardware.motor;

import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.TachoMotorPort;
import lejos.internal.ev3.EV3Ports;
import lejos.robotics.Encoder;
import lejos.robotics.EncoderMotor;

/** A motor with an encoder driven with plain power. */
public class UnregulatedMotor extends BasicMotor implements EncoderMotor {
    /** The encoder: the port's own counter. */
    protected Encoder encoderPort;

    /**
     * A motor on a port that is opened now and closed with the motor.
     *
     * @param pwmMode ignored by an EV3
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public UnregulatedMotor(Port port, int pwmMode) {
        this(port.open(TachoMotorPort.class), pwmMode);
        releaseOnClose(this.port);
    }

    /**
     * A motor on a port that is opened now and closed with the motor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public UnregulatedMotor(Port port) {
        this(port, BasicMotorPort.PWM_BRAKE);
    }

    /**
     * A motor on an open port, which {@link #close()} leaves open.
     *
     * @param pwmMode ignored by an EV3
     */
    public UnregulatedMotor(TachoMotorPort port, int pwmMode) {
        EV3Ports.announce(port, this);
        this.port = port;
        encoderPort = port;
        port.setPWMMode(pwmMode);
    }

    /** A motor on an open port, which {@link #close()} leaves open. */
    public UnregulatedMotor(TachoMotorPort port) {
        this(port, BasicMotorPort.PWM_BRAKE);
    }

    @Override
    public int getTachoCount() {
        return encoderPort.getTachoCount();
    }

    @Override
    public void resetTachoCount() {
        encoderPort.resetTachoCount();
    }
}
