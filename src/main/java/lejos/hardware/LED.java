package lejos.hardware;

/** The LEDs behind the keys. */
public interface LED {
    /**
     * Shows a pattern; does not block.
     *
     * @param pattern 0 off; 1, 2, 3 green, red, orange; 4, 5, 6 the same flashing; 7, 8, 9 the same pulsing; others are
     *     ignored
     */
    void setPattern(int pattern);
}
