package lejos.robotics;

/** An {@link Encoder} that also measures speed. */
public interface Tachometer extends Encoder {
    /** Measured speed in degrees per second, positive forward. */
    int getRotationSpeed();
}
