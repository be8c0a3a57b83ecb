package brickless.device.motor;

/** Processor time that socket calls take, nanoseconds: estimates for the EV3's 300 MHz ARM9. */
final class Charges {
    static final long MOTOR_COMMAND = 300_000;
    static final long MOTOR_QUERY = 20_000;

    private Charges() {}
}
