package lejos.hardware.port;

import java.io.Closeable;

/** An opened port. */
public interface IOPort extends Closeable {
    /** Frees the port; it can be opened again at once. */
    @Override
    void close();

    /** The port's name, e.g. {@code "S1"}. */
    String getName();

    /**
     * Drives the pins directly.
     *
     * @param mode one of the {@code CMD_…} numbers of {@link lejos.hardware.sensor.EV3SensorConstants}
     * @return whether the driver took it
     */
    boolean setPinMode(int mode);
}
