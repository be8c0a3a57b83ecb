package lejos.hardware.sensor;

import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;
import lejos.internal.ev3.EV3Ports;
import lejos.utility.Delay;

/** Base of sensors that answer with a voltage. Whether such a sensor is plugged in cannot be found out. */
public class AnalogSensor extends BaseSensor implements SensorConstants {
    /** The port. */
    protected AnalogPort port;
    /** The type last set by {@link #switchType(int, long)}, −1 at first. */
    protected int currentType = -1;

    /** A sensor on an open port, which {@link #close()} leaves open and whose type is left as it is. */
    public AnalogSensor(AnalogPort p) {
        port = p;
        EV3Ports.announce(p, this);
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks for one fresh sample.
     *
     * @param type how the pins are driven, a {@code TYPE_…} number
     * @param mode port mode, usually {@link #MODE_RAW}
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a sensor port
     */
    public AnalogSensor(Port p, int type, int mode) {
        this(p.open(AnalogPort.class));
        releaseOnClose(port);
        port.setType(type);
        port.setMode(mode);
    }

    /**
     * A plain analogue sensor ({@link #TYPE_CUSTOM}) on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a sensor port
     */
    public AnalogSensor(Port p) {
        this(p, TYPE_CUSTOM, MODE_RAW);
    }

    /** Volts as a share of the converter's range, 0 to 1. */
    protected float normalize(float val) {
        return val / EV3SensorConstants.ADC_REF;
    }

    /** Volts as an NXT would have measured them, 0 to 1023. */
    protected float NXTRawValue(float val) {
        return val * NXT_ADC_RES / EV3SensorConstants.ADC_REF;
    }

    /** Volts as an NXT would have measured them, rounded. */
    protected int NXTRawIntValue(float val) {
        return Math.round(NXTRawValue(val));
    }

    /**
     * Changes how the pins are driven, unless they are driven so already.
     *
     * @param newType a {@code TYPE_…} number
     * @param switchDelay wait after a change, milliseconds
     * @throws IllegalArgumentException if the port cannot drive them so
     */
    protected void switchType(int newType, long switchDelay) {
        if (currentType == newType) {
            return;
        }
        if (!port.setType(newType)) {
            throw new IllegalArgumentException("Invalid sensor type");
        }
        currentType = newType;
        Delay.msDelay(switchDelay);
    }
}
