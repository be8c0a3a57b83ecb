package lejos.hardware.sensor;

import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;

/** The EV3 touch sensor. Mode 0 "Touch": 1 pressed, 0 not pressed or nothing plugged in. */
public class EV3TouchSensor extends AnalogSensor {
    private static final float PRESSED_VOLTS = EV3SensorConstants.ADC_REF / 2;

    /** A sensor on an open port, which {@link #close()} leaves open. */
    public EV3TouchSensor(AnalogPort port) {
        super(port);
        init();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public EV3TouchSensor(Port port) {
        super(port);
        init();
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new TouchMode()});
    }

    /** Mode "Touch": 1 pressed, 0 not. */
    public SensorMode getTouchMode() {
        return getMode(0);
    }

    private final class TouchMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            sample[offset] = port.getPin6() > PRESSED_VOLTS ? 1 : 0;
        }

        @Override
        public String getName() {
            return "Touch";
        }
    }
}
