package lejos.robotics;

/** A counter of rotation. */
public interface Encoder {
    /** Angle since the last reset, in degrees, positive forward. */
    int getTachoCount();

    /** Makes the present angle zero. */
    void resetTachoCount();
}
