package lejos.hardware.sensor;

import lejos.hardware.port.LegacySensorPort;

/**
 * The RCX temperature sensor: mode 0 "Temperature" in kelvin.
 *
 * <p>No port of an EV3 is a {@link LegacySensorPort}: only a program that brings its own port can use it.
 */
public class RCXThermometer extends AnalogSensor implements SensorConstants {
    private static final float KELVIN_AT_ZERO_CELSIUS = 273.15f;
    private static final float RAW_AT_ZERO_CELSIUS = 785;
    private static final float RAW_PER_DEGREE = 8;

    /** A sensor on an open port, which {@link #close()} leaves open. */
    public RCXThermometer(LegacySensorPort port) {
        super(port);
        init();
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new TemperatureMode()});
    }

    /** Mode "Temperature": kelvin. */
    public SensorMode getTemperatureMode() {
        return getMode(0);
    }

    private final class TemperatureMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            float raw = NXTRawValue(port.getPin1());
            sample[offset] = (RAW_AT_ZERO_CELSIUS - raw) / RAW_PER_DEGREE + KELVIN_AT_ZERO_CELSIUS;
        }

        @Override
        public String getName() {
            return "Temperature";
        }
    }
}
