package brickless.hardware;

/** The battery. */
public interface PowerSocket {
    /** Voltage at the terminals, volts, sagging with the current drawn. */
    float voltageVolts();

    /** Current drawn from the battery, amperes. */
    float batteryCurrentAmperes();

    /** Current drawn by the motors together, amperes. */
    float motorCurrentAmperes();
}
