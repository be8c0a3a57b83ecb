package lejos.hardware;

import lejos.utility.Delay;

/** The brick's WiFi adapter. No access point is in range of a virtual brick. */
public class LocalWifiDevice {
    private static final int SCAN_MILLIS = 2000;

    LocalWifiDevice() {}

    /** Names of the access points in range; blocks for 2 s. */
    public String[] getAccessPointNames() {
        Delay.msDelay(SCAN_MILLIS);
        return new String[0];
    }

    /** Address of the access point in use: null, as there is none. */
    public String getAccessPoint() {
        return null;
    }
}
