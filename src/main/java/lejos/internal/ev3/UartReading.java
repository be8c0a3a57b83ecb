package lejos.internal.ev3;

import java.util.Map;

/** Formats raw serial readings as LEGO's sensors describe them: value type, decimal places, unit. */
final class UartReading {
    /** Format of a mode: two-byte value or one-byte value, decimal places of the shown number, unit. */
    private record Format(boolean wide, int decimals, String unit) {}

    private static final Format PLAIN = new Format(false, 0, "");
    private static final Map<String, Format> FORMATS = Map.of(
            "US-DIST-CM", new Format(true, 1, "cm"), "US-DIST-IN", new Format(true, 1, "in"),
            "COL-REFLECT", new Format(false, 0, "pct"), "COL-AMBIENT", new Format(false, 0, "pct"),
            "COL-COLOR", new Format(false, 0, "col"), "GYRO-ANG", new Format(true, 0, "deg"),
            "GYRO-RATE", new Format(true, 0, "d/s"), "GYRO-G&A", new Format(true, 0, "deg"),
            "RGB-RAW", new Format(true, 0, ""), "IR-PROX", new Format(false, 0, "pct"));

    private UartReading() {}

    static String format(String modeName, byte[] message) {
        Format format = FORMATS.getOrDefault(modeName, PLAIN);
        int raw = format.wide() ? message[0] & 0xff | message[1] << 8 : message[0];
        if (format.decimals() == 0) {
            return raw + format.unit();
        }
        return (raw < 0 ? "-" : "") + Math.abs(raw) / 10 + "." + Math.abs(raw) % 10 + format.unit();
    }
}
