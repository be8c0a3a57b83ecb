package lejos.hardware;

import java.io.IOException;

/** Entry to WiFi. */
public class Wifi {
    /** Creates an object nobody needs: all methods are static. */
    public Wifi() {}

    /** The adapter of that name; all names lead to an adapter without a network. */
    public static LocalWifiDevice getLocalDevice(String ifName) {
        return new LocalWifiDevice();
    }

    /**
     * Names of the adapters: none is plugged into a virtual brick.
     *
     * @throws IOException never; declared for compatibility
     */
    public static String[] getIfNames() throws IOException {
        return new String[0];
    }
}
