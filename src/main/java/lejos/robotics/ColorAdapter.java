package lejos.robotics;

import lejos.hardware.sensor.BaseSensor;

/** A colour sensor as a {@link ColorDetector}. */
public class ColorAdapter implements ColorDetector, ColorIdentifier {
    private static final int FULL_SCALE = 256;

    private final SampleProvider colors;
    private final SampleProvider names;
    private final float[] sample = new float[3];

    /**
     * An adapter.
     *
     * @throws IllegalArgumentException if the sensor has no modes called RGB and ColorID
     */
    public ColorAdapter(BaseSensor sensor) {
        colors = sensor.getMode("RGB");
        names = sensor.getMode("ColorID");
    }

    @Override
    public int getColorID() {
        names.fetchSample(sample, 0);
        return (int) sample[0];
    }

    /** The colour seen, each component from 0 to 256. */
    @Override
    public Color getColor() {
        colors.fetchSample(sample, 0);
        return new Color(component(0), component(1), component(2));
    }

    private int component(int index) {
        return (int) (FULL_SCALE * sample[index]);
    }
}
