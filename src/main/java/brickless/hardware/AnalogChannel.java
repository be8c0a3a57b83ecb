package brickless.hardware;

/** The analogue pins of an input port: a 12-bit converter with a 5 V reference. */
public interface AnalogChannel {
    /** Latest sample of pin 1 in volts, 0 to 5. Does not block. */
    double pin1Volts();

    /** Latest sample of pin 6 in volts, 0 to 5. Does not block. */
    double pin6Volts();

    /**
     * Sets the pin drive for an NXT/RCX sensor type number (0 to 19 of {@code SensorConstants}) and waits for one fresh
     * sample.
     *
     * @return false if the type cannot be driven on analogue pins
     */
    boolean setType(int type);

    /**
     * Reads the voltages of an NXT colour sensor.
     *
     * @return red, green, blue, background in volts, and as fifth value the LEGO colour id 1 to 6 (0 = none); empty
     *         when no such sensor is plugged
     */
    float[] colourVolts();
}
