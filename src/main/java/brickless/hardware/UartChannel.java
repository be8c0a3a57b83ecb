package brickless.hardware;

/** The serial line to a self-describing sensor with numbered modes. Messages are little-endian. */
public interface UartChannel {
    /**
     * Connects to the device and selects a mode, blocking until the device sends data.
     *
     * @return false if no serial device answers or it has no such mode
     */
    boolean initialise(int mode);

    /**
     * Switches the mode, blocking until data of the new mode arrives; false if the device has no such mode or is gone.
     */
    boolean setMode(int mode);

    /** Restarts the device: it sends nothing (and is dark) until the next {@link #initialise(int)}. */
    void reset();

    /**
     * Copies the newest message of the present mode.
     *
     * @return number of bytes copied, at most {@code length}; 0 when nothing has arrived
     */
    int read(byte[] destination, int offset, int length);

    /** Sends bytes to the device; returns how many it took. */
    int write(byte[] source, int offset, int length);

    /** The device's own name of a mode, e.g. {@code US-DIST-CM}; {@code Unknown} if there is none. */
    String modeName(int mode);
}
