package lejos.hardware.sensor;

/**
 * Light level of an analogue sensor whose voltage falls as it gets brighter, measured with the lamp as one type number
 * sets it.
 */
final class LightMode implements SensorMode {
    /** Wait after the lamp has changed, milliseconds. */
    static final long SWITCH_DELAY = 10;

    private final AnalogSensor sensor;
    private final String name;
    private final int type;

    LightMode(AnalogSensor sensor, String name, int type) {
        this.sensor = sensor;
        this.name = name;
        this.type = type;
    }

    @Override
    public int sampleSize() {
        return 1;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        sensor.switchType(type, SWITCH_DELAY);
        sample[offset] = 1.0f - sensor.normalize(sensor.port.getPin1());
    }

    @Override
    public String getName() {
        return name;
    }
}
