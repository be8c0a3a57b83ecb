package lejos.hardware.sensor;

import lejos.hardware.port.LegacySensorPort;

/**
 * The RCX temperature sensor: mode 0 "Temperature" in kelvin.
 *
 * <p>It cannot be used: no port of an EV3 is a {@link LegacySensorPort}, and the original's constructor fails with a
 * {@link NullPointerException}, which is kept.
 */
public class RCXThermometer extends AnalogSensor implements SensorConstants {
    private static final float KELVIN_AT_ZERO_CELSIUS = 273.15f;
    private static final float RAW_AT_ZERO_CELSIUS = 785;
    private static final float RAW_PER_DEGREE = 8;

    /** The port the original forgot to set. */
    private LegacySensorPort legacyPort;

    /**
     * Always fails.
     *
     * @throws NullPointerException always
     */
    public RCXThermometer(LegacySensorPort port) {
        super(port);
        init();
    }

    /** Sets the modes and powers the sensor. */
    protected void init() {
        setModes(new SensorMode[] {new TemperatureMode()});
        legacyPort.activate();
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
            float raw = NXTRawValue(legacyPort.getPin1());
            sample[offset] = (RAW_AT_ZERO_CELSIUS - raw) / RAW_PER_DEGREE + KELVIN_AT_ZERO_CELSIUS;
        }

        @Override
        public String getName() {
            return "Temperature";
        }
    }
}
