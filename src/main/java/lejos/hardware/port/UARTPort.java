package lejos.hardware.port;

/**
 * A port opened for a sensor that describes itself over a serial line and has numbered modes.
 *
 * <p>Reads return the newest message of the present mode and do not block; changing the mode does.
 */
public interface UARTPort extends IOPort, BasicSensorPort {
    /** Mode number of a line without the sensor protocol. */
    int UART_RAW_MODE = -1;

    /** First byte of the newest message, signed. */
    byte getByte();

    /** First bytes of the newest message. */
    void getBytes(byte[] vals, int offset, int len);

    /** First two bytes of the newest message as a signed little-endian number. */
    int getShort();

    /** The newest message as signed 16-bit little-endian numbers. */
    void getShorts(short[] vals, int offset, int len);

    /** The device's own name of a mode, e.g. {@code US-DIST-CM}; {@code Unknown} if it has no such mode. */
    String getModeName(int mode);

    /** The present reading with its unit. */
    @Override
    String toString();

    /**
     * Connects to the sensor and selects a mode, blocking until it sends data.
     *
     * @return false if no serial sensor answers or it has no such mode
     */
    boolean initialiseSensor(int mode);

    /** Restarts the sensor; the next change of mode connects to it again. */
    void resetSensor();

    /** Sends bytes to the sensor; returns how many were taken. */
    int write(byte[] buffer, int offset, int len);

    /** Reads bytes of a line in raw mode without blocking; returns how many. */
    int rawRead(byte[] buffer, int offset, int len);

    /** Writes bytes to a line in raw mode without blocking; returns how many. */
    int rawWrite(byte[] buffer, int offset, int len);

    /** Sets the speed of a line in raw mode, bits per second. */
    void setBitRate(int bitRate);
}
