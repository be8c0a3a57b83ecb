package brickless.device.sensor;

/**
 * One mode of a serial device.
 *
 * @param name LEGO's name
 * @param bytes length of a message
 * @param switchNanos time until the first message after it was selected: assumption within 20 to 50 ms
 */
record UartMode(String name, int bytes, long switchNanos) {
    /** Mode that is there quickly: 20 ms. */
    static UartMode quick(String name, int bytes) {
        return new UartMode(name, bytes, 20_000_000);
    }

    /** Mode that needs a cycle of a slower device: 50 ms. */
    static UartMode slow(String name, int bytes) {
        return new UartMode(name, bytes, 50_000_000);
    }
}
