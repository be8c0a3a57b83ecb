package brickless.hardware;

/** One output port (A to D) with whatever motor is plugged in; an empty port accepts everything and never turns. */
public interface MotorSocket {
    /**
     * Drives the motor with a fixed duty, ending any regulation.
     *
     * @param dutyPercent −100 (full backward) to 100 (full forward); values outside are clamped
     */
    void drive(int dutyPercent);

    /** Shorts the motor's terminals, ending any regulation. */
    void brake();

    /** Opens the motor's terminals, ending any regulation: the wheel can be turned freely. */
    void coast();

    /** Encoder count in whole degrees since the last {@link #resetTacho()}, forward positive. */
    int tachoDegrees();

    /** Makes the present encoder count zero. Does not disturb a regulated move. */
    void resetTacho();

    /** The closed-loop controller of this port. The same object on every call. */
    MotorRegulation regulation();

    /** Name of the plugged motor type for messages, e.g. {@code ev3-large}, or {@code none}. */
    String connected();

    /**
     * Tells which leJOS class is about to use the port, so that an automatically fitted robot can plug a motor in.
     *
     * @param lejosClass simple name, e.g. {@code EV3LargeRegulatedMotor}
     */
    void expect(String lejosClass);

    /** Frees the port: any regulation ends, the motor coasts, and the next use starts with default settings. */
    void release();
}
