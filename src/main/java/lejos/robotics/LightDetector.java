package lejos.robotics;

/** A sensor of brightness. */
public interface LightDetector {
    /** Brightness in the sensor's own scale. */
    float getLightValue();

    /** Brightness from 0 at {@link #getLow()} to 1 at {@link #getHigh()}. */
    float getNormalizedLightValue();

    /** Value of the brightest light calibrated for. */
    float getHigh();

    /** Value of the darkest light calibrated for. */
    float getLow();
}
