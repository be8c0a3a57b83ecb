package lejos.robotics;

/** A sensor's own light. */
public interface LampController {
    /** Turns the light on in its default colour, or off. */
    void setFloodlight(boolean floodlight);

    /** Whether the light is on. */
    boolean isFloodlightOn();

    /** Present colour of the light, one of the constants of {@link Color}; {@link Color#NONE} if it is off. */
    int getFloodlight();

    /**
     * Chooses the colour of the light.
     *
     * @param color one of the constants of {@link Color}; {@link Color#NONE} turns it off
     * @return false if the sensor has no such light
     */
    boolean setFloodlight(int color);
}
