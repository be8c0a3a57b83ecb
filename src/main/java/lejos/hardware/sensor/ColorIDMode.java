package lejos.hardware.sensor;

import lejos.robotics.ColorIdentifier;

/** Mode "ColorID" of a colour sensor: a {@link lejos.robotics.Color} number, −1 for none. */
final class ColorIDMode implements SensorMode {
    private final ColorIdentifier sensor;

    ColorIDMode(ColorIdentifier sensor) {
        this.sensor = sensor;
    }

    @Override
    public int sampleSize() {
        return 1;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        sample[offset] = sensor.getColorID();
    }

    @Override
    public String getName() {
        return "ColorID";
    }
}
