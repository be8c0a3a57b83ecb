package lejos.hardware.sensor;

import lejos.hardware.DeviceException;
import lejos.hardware.port.Port;
import lejos.hardware.port.UARTPort;
import lejos.internal.ev3.EV3Ports;

/** Base of sensors on a serial line. The device measures in one hardware mode at a time. */
public class UARTSensor extends BaseSensor {
    /** The line. */
    protected UARTPort port;
    /** The mode the <em>device</em> is in, −1 after a reset; not the list index of {@link BaseSensor}. */
    protected int currentMode;

    /**
     * A sensor on an open port, which {@link #close()} leaves open, in hardware mode 0.
     *
     * @throws DeviceException if no serial sensor answers
     */
    public UARTSensor(UARTPort port) {
        this(port, 0);
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor, in hardware mode 0.
     *
     * @throws DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a sensor port or no serial sensor answers; the port is free
     *         afterwards
     */
    public UARTSensor(Port port) {
        this(port, 0);
    }

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @param mode hardware mode to start in
     * @throws DeviceException if no serial sensor answers or it has no such mode
     */
    public UARTSensor(UARTPort port, int mode) {
        this.port = port;
        EV3Ports.announce(port, this);
        if (!port.initialiseSensor(mode)) {
            throw new DeviceException("Unable to initialize device", EV3Ports.mismatch(port));
        }
        currentMode = mode;
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @param mode hardware mode to start in
     * @throws DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a sensor port, no serial sensor answers or it has no such mode; the
     *         port is free afterwards
     */
    public UARTSensor(Port port, int mode) {
        this.port = port.open(UARTPort.class);
        releaseOnClose(this.port);
        EV3Ports.announce(this.port, this);
        if (!this.port.setMode(mode)) {
            Throwable mismatch = EV3Ports.mismatch(this.port);
            this.port.close();
            throw new IllegalArgumentException("Invalid sensor mode", mismatch);
        }
        currentMode = mode;
    }

    /**
     * Brings the device into a hardware mode, blocking until it has data, unless it is in that mode already.
     *
     * @param newMode hardware mode; −1 resets the device
     * @param switchDelay ignored: the device itself tells when it is ready
     * @throws IllegalArgumentException if the device refuses
     */
    protected void switchMode(int newMode, long switchDelay) {
        if (newMode == currentMode) {
            return;
        }
        if (newMode == -1) {
            port.resetSensor();
        } else if (!port.setMode(newMode)) {
            throw new IllegalArgumentException("Invalid sensor mode", EV3Ports.mismatch(port));
        }
        currentMode = newMode;
    }
}
