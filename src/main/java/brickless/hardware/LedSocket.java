package brickless.hardware;

/** The LEDs behind the keys. */
public interface LedSocket {
    /** Shows pattern 0 (off) to 9; other numbers are ignored. Does not block. */
    void setPattern(int pattern);
}
