package lejos.robotics;

import lejos.hardware.sensor.BaseSensor;

/** A touch sensor as a {@link Touch}. */
public class TouchAdapter implements Touch {
    private final SampleProvider mode;
    private final float[] sample;

    /**
     * An adapter.
     *
     * @throws IllegalArgumentException if the sensor has no mode called Touch
     */
    public TouchAdapter(BaseSensor sensor) {
        mode = sensor.getMode("Touch");
        sample = new float[mode.sampleSize()];
    }

    @Override
    public boolean isPressed() {
        mode.fetchSample(sample, 0);
        return sample[0] > 0;
    }
}
