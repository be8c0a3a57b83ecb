package lejos.hardware.motor;

import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.Port;
import lejos.internal.ev3.EV3Ports;

/** A motor without an encoder. */
public class RCXMotor extends BasicMotor {
    /** A motor on an open port, which {@link #close()} leaves open. */
    public RCXMotor(BasicMotorPort port) {
        EV3Ports.announce(port, this);
        this.port = port;
    }

    /**
     * A motor on a port that is opened now and closed with the motor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public RCXMotor(Port port) {
        this(port.open(BasicMotorPort.class));
        releaseOnClose(this.port);
    }
}
