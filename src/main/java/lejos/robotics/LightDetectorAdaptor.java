package lejos.robotics;

import lejos.hardware.sensor.SensorMode;
import lejos.hardware.sensor.SensorModes;
import lejos.utility.Delay;

/** A colour or light sensor as a detector of brightness, its own light on or off. */
public class LightDetectorAdaptor {
    private static final int SETTLING_MILLIS = 10;

    private final SensorModes sensor;
    private SensorMode mode;
    private float high;
    private float low;

    /**
     * An adapter that measures ambient light.
     *
     * @param source a colour or light sensor, with modes called Red and Ambient
     * @throws IllegalArgumentException if it is something else
     */
    public LightDetectorAdaptor(SampleProvider source) {
        if (!(source instanceof SensorModes modes)) {
            throw new IllegalArgumentException("not a light sensor: " + source.getClass().getName());
        }
        sensor = modes;
        mode = modes.getMode("Ambient");
    }

    /**
     * Chooses between reflected light, with the sensor's light on, and ambient light, with it off.
     *
     * @throws ClassCastException if the sensor has no light
     */
    public void setReflected(boolean reflected) {
        ((LampController) sensor).setFloodlight(reflected);
        mode = sensor.getMode(reflected ? "Red" : "Ambient");
    }

    /** Name of the mode that measures. */
    public String getMode() {
        return mode.getName();
    }

    /** Brightness in the sensor's own scale; takes 10 ms. */
    public float getLightValue() {
        Delay.msDelay(SETTLING_MILLIS);
        float[] sample = new float[mode.sampleSize()];
        mode.fetchSample(sample, 0);
        return sample[0];
    }

    /** Brightness from 0 at the low value to 1 at the high one; infinite or not a number until those are set. */
    public float getNormalizedLightValue() {
        return (getLightValue() - low) / (high - low);
    }

    /** Sets the value of the brightest light. */
    public void setHigh(float high) {
        this.high = high;
    }

    /** The value of the brightest light. */
    public float getHigh() {
        return high;
    }

    /** Sets the value of the darkest light. */
    public void setLow(float low) {
        this.low = low;
    }

    /** The value of the darkest light. */
    public float getLow() {
        return low;
    }
}
