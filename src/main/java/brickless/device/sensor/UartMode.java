package brickless.device.sensor;

/**
 * One mode of a serial device.
 *
 * @param name LEGO's name
 * @param values numbers in a message
 * @param bytesPerValue 1 or 2; all are signed
 * @param switchNanos time until the first message after it was selected: assumption within 20 to 50 ms
 */
record UartMode(String name, int values, int bytesPerValue, long switchNanos) {
    private static final long QUICK_NANOS = 20_000_000;
    private static final long SLOW_NANOS = 50_000_000;

    /** A mode that is there quickly: 20 ms. */
    static UartMode quick(String name, int values, int bytesPerValue) {
        return new UartMode(name, values, bytesPerValue, QUICK_NANOS);
    }

    /** A mode that needs a cycle of a slower device: 50 ms. */
    static UartMode slow(String name, int values, int bytesPerValue) {
        return new UartMode(name, values, bytesPerValue, SLOW_NANOS);
    }

    /** Length of a message. */
    int bytes() {
        return values * bytesPerValue;
    }

    /** A number of a message. */
    int value(byte[] message, int index) {
        return bytesPerValue == 1 ? message[index] : (short) (message[2 * index] & 0xff | message[2 * index + 1] << 8);
    }
}
