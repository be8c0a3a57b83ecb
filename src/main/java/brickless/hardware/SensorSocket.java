package brickless.hardware;

/**
 * One input port (S1 to S4) with whatever sensor is plugged in.
 *
 * <p>A channel may be used whether or not a device of its kind is plugged; the channel's methods then answer as an
 * empty port would.
 */
public interface SensorSocket {
    /** How the plugged device talks. */
    enum Wiring { NONE, ANALOG, UART, I2C }

    /** How the plugged device talks, {@link Wiring#NONE} when the port is empty. */
    Wiring wiring();

    /**
     * LEGO device type number of the plugged device (16 EV3 touch, 29 colour, 30 ultrasonic, 32 gyro, 33 infrared, 1
     * NXT touch …), 126 when empty.
     */
    int deviceType();

    /** Name of the plugged device in the vocabulary of robot files, e.g. {@code ev3-ultrasonic}, or {@code none}. */
    String connected();

    /**
     * Tells which leJOS class is about to use the port, so that an automatically fitted robot can plug a device in and
     * messages can say what was expected.
     *
     * @param lejosClass simple name, e.g. {@code EV3UltrasonicSensor}
     */
    void expect(String lejosClass);

    /** The analogue pins. */
    AnalogChannel analog();

    /** The serial line. */
    UartChannel uart();

    /** The I²C bus. */
    I2cChannel i2c();

    /** Frees the port: the device falls back to its power-on state. */
    void release();
}
