import lejos.hardware.port.Port;
import lejos.hardware.sensor.AnalogSensor;
import lejos.hardware.sensor.SensorMode;

/** A driver for the NXT touch sensor, which pulls pin 1 down. */
class Bumper extends AnalogSensor implements SensorMode {
    private static final float HALF = 2.5f;

    Bumper(Port port) {
        super(port);
        setModes(new SensorMode[] {this});
    }

    boolean isPressed() {
        return port.getPin1() < HALF;
    }

    @Override
    public int sampleSize() {
        return 1;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        sample[offset] = isPressed() ? 1 : 0;
    }

    @Override
    public String getName() {
        return "Bumper";
    }
}
