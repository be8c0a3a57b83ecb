package brickless.device.sensor;

/** Processor time that socket calls take, nanoseconds: estimates for the EV3's 300 MHz ARM9. */
final class Charges {
    static final long SENSOR_READ = 200_000;
    static final long I2C_TRANSACTION = 5_000_000;

    private Charges() {}
}
