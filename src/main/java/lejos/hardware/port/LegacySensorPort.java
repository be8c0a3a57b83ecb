package lejos.hardware.port;

/** An analogue port that can power an RCX sensor; the EV3 has none, so no port can be opened as one. */
public interface LegacySensorPort extends AnalogPort {
    /** Powers the sensor. */
    void activate();

    /** Takes the power off. */
    void passivate();
}
