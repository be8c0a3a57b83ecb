package lejos.hardware;

import java.util.Locale;
import lejos.remote.nxt.BTConnector;
import lejos.remote.nxt.NXTCommConnector;

/** Entry to Bluetooth. */
public class Bluetooth {
    private static final int ADDRESS_BYTES = 6;
    private static final int HEX = 16;

    /** Creates an object nobody needs: all methods are static. */
    public Bluetooth() {}

    /** A new connector for connections to other bricks. */
    public static NXTCommConnector getNXTCommConnector() {
        return new BTConnector();
    }

    /** The radio of the local brick. */
    public static LocalBTDevice getLocalDevice() {
        return new LocalBTDevice();
    }

    /** An address such as {@code 00:16:53:44:97:4F} as six bytes, the last one first. */
    public static byte[] getAddress(String address) {
        String[] parts = address.split(":");
        byte[] bytes = new byte[ADDRESS_BYTES];
        for (int i = 0; i < ADDRESS_BYTES; i++) {
            bytes[ADDRESS_BYTES - 1 - i] = (byte) Integer.parseInt(parts[i], HEX);
        }
        return bytes;
    }

    /** Six bytes, the last one first, as an address such as {@code 00:16:53:44:97:4F}. */
    public static String getAddress(byte[] address) {
        StringBuilder text = new StringBuilder();
        for (int i = ADDRESS_BYTES - 1; i >= 0; i--) {
            text.append(String.format(Locale.ROOT, "%02X", address[i])).append(i > 0 ? ":" : "");
        }
        return text.toString();
    }
}
