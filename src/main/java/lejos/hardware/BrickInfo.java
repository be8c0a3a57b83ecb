package lejos.hardware;

/** What a search found out about a brick. */
public class BrickInfo {
    private final String name;
    private final String ipAddress;
    private final String type;

    /** A brick by name, address and type. */
    public BrickInfo(String name, String ipAddress, String type) {
        this.name = name;
        this.ipAddress = ipAddress;
        this.type = type;
    }

    /** Name of the brick. */
    public String getName() {
        return name;
    }

    /** Its IP address, or Bluetooth address for an NXT. */
    public String getIPAddress() {
        return ipAddress;
    }

    /** {@code "EV3"} or {@code "NXT"}. */
    public String getType() {
        return type;
    }
}
