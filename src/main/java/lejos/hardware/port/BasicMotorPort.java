package lejos.hardware.port;

/** A port opened for a motor without an encoder. */
public interface BasicMotorPort extends IOPort {
    /** PWM mode that lets the motor float between pulses. */
    int PWM_FLOAT = 0;
    /** PWM mode that brakes the motor between pulses. */
    int PWM_BRAKE = 1;
    /** Turn forward. */
    int FORWARD = 1;
    /** Turn backward. */
    int BACKWARD = 2;
    /** Brake: short the terminals. */
    int STOP = 3;
    /** Coast: open the terminals. */
    int FLOAT = 4;
    /** Full power. */
    int MAX_POWER = 100;

    /**
     * Drives the motor at once and without regulation.
     *
     * @param power duty in percent, −100 to 100; negative reverses
     * @param mode {@link #FORWARD}, {@link #BACKWARD}, {@link #STOP} or {@link #FLOAT}; the last two ignore the power
     */
    void controlMotor(int power, int mode);

    /** Has no effect on an EV3, which always brakes between pulses. */
    void setPWMMode(int mode);
}
