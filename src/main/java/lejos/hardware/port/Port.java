package lejos.hardware.port;

/** A socket of the brick: S1 to S4 for sensors, A to D for motors. */
public interface Port {
    /** The port's name, e.g. {@code "S1"} or {@code "A"}. */
    String getName();

    /**
     * Opens the port for one way of talking to the device. Whether a device is plugged in is not checked. Does not
     * block.
     *
     * @param portclass the interface wanted, e.g. {@link UARTPort}
     * @throws IllegalArgumentException if this kind of port has no such interface
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    <T extends IOPort> T open(Class<T> portclass);
}
