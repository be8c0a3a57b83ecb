package lejos.hardware;

import java.io.Serializable;

/** What is known about another Bluetooth device. */
public class RemoteBTDevice implements Serializable {
    private static final long serialVersionUID = 1L;

    private final String name;
    private final byte[] address;
    private final int deviceClass;

    /**
     * A device.
     *
     * @param name its name
     * @param address six bytes, the last one first
     * @param cod class of device
     */
    public RemoteBTDevice(String name, byte[] address, int cod) {
        this.name = name;
        this.address = address;
        this.deviceClass = cod;
    }

    /** Name of the device. */
    public String getName() {
        return name;
    }

    /** Its address as six bytes, the last one first. */
    public byte[] getDeviceAddress() {
        return address;
    }

    /** Its class of device. */
    public int getDeviceClass() {
        return deviceClass;
    }

    /** Its address as text, e.g. {@code 00:16:53:44:97:4F}. */
    public String getAddress() {
        return Bluetooth.getAddress(address);
    }

    /** Does nothing, as in leJOS; see {@link LocalBTDevice#authenticate}. */
    public void authenticate(String pin) {
        // Kept for compatibility: pairing is done by the local device.
    }
}
