package lejos.robotics;

/** An unregulated motor that counts its rotation. */
public interface EncoderMotor extends DCMotor, Encoder {
}
