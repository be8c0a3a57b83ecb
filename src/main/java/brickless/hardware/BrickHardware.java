package brickless.hardware;

/**
 * One virtual EV3 as its program sees it, below {@code lejos.*}.
 *
 * <p>All methods of all sockets are called by threads of the program that runs on this brick, one at a time unless a
 * method says otherwise. Reads and commands take simulated processor time, which the implementation charges itself.
 */
public interface BrickHardware {
    /** Name of the brick, as {@code Brick.getName()} reports it. */
    String name();

    /**
     * Output port.
     *
     * @param index 0 to 3 for ports A to D
     */
    MotorSocket motor(int index);

    /**
     * Input port.
     *
     * @param index 0 to 3 for ports S1 to S4
     */
    SensorSocket sensor(int index);

    /** Starts several regulated moves in the same control tick; {@code requests[i]} is for port {@code ports[i]}. */
    void moveTogether(int[] ports, MoveRequest[] requests);

    /** The 178 × 128 pixel screen. */
    ScreenSocket screen();

    /** The six keys. */
    KeySocket keys();

    /** The two LEDs behind the keys. */
    LedSocket leds();

    /** The loudspeaker. */
    SpeakerSocket speaker();

    /** The battery. */
    PowerSocket power();

    /** What the program tells the outside: printed text, uncaught exceptions, arbitration. */
    ProgramLog log();
}
