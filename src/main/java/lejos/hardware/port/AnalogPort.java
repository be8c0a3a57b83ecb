package lejos.hardware.port;

/** A port opened for a device that answers with voltages. */
public interface AnalogPort extends IOPort, BasicSensorPort {
    /** Latest sample of pin 6 in volts, 0 to 5. Does not block. */
    float getPin6();

    /** Latest sample of pin 1 in volts, 0 to 5. Does not block. */
    float getPin1();

    /**
     * Reads an NXT colour sensor: voltages of red, green, blue and background, then the LEGO colour id 1 to 6 (0 =
     * none).
     *
     * @param vals array to fill
     * @param offset index of the first element to fill
     * @param length how many values, 1 to 5
     */
    void getFloats(float[] vals, int offset, int length);
}
