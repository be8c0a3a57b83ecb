package lejos.hardware.port;

import lejos.hardware.motor.MotorRegulator;
import lejos.robotics.Encoder;

/**
 * A port opened for a motor with an encoder. The count is the hardware's own: resetting it clears it for every user of
 * the port.
 */
public interface TachoMotorPort extends BasicMotorPort, Encoder {
    /** The regulator of this open port; the same object on every call. */
    MotorRegulator getRegulator();
}
