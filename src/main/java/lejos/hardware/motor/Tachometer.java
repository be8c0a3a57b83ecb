package lejos.hardware.motor;

/** A counter of turned degrees. Kept for old programs; {@link lejos.robotics.Encoder} is what the library uses. */
public interface Tachometer {
    /** Degrees turned since the last reset, forward positive. */
    int getTachoCount();

    /** Makes the present count zero. */
    void resetTachoCount();
}
