package brickless.device.battery;

import brickless.hardware.PowerSocket;

/** A battery with an inner resistance: its terminal voltage sags with the current drawn in the last step. */
public final class Battery implements PowerSocket {
    /** Typical reading of a charged EV3 battery in use, volts (7.2 to 9 V are met). */
    public static final double NOMINAL_VOLTS = 8.2;
    /** Inner resistance of the pack with its wiring, ohms: assumption, 0.1 to 0.2. */
    public static final double RESISTANCE_OHMS = 0.15;
    /** Current of the brick itself, amperes: assumption. */
    public static final double IDLE_AMPERES = 0.17;

    private double openVolts = NOMINAL_VOLTS;
    private double motorAmperes;
    private double drawnAmperes = IDLE_AMPERES;

    /** Sets the voltage without load, volts. */
    public void setOpenVolts(double volts) {
        openVolts = volts;
    }

    /** Voltage at the terminals, volts. */
    public double terminalVolts() {
        return openVolts - RESISTANCE_OHMS * drawnAmperes;
    }

    /**
     * Sets the load of the coming step.
     *
     * @param inMotorsAmperes sum of the currents in the motors' windings, all counted positive
     * @param fromBatteryAmperes what they take from the battery: less at part duty, negative when braking returns
     *         energy
     */
    public void load(double inMotorsAmperes, double fromBatteryAmperes) {
        motorAmperes = inMotorsAmperes;
        drawnAmperes = Math.max(0, IDLE_AMPERES + fromBatteryAmperes);
    }

    @Override
    public float voltageVolts() {
        return (float) terminalVolts();
    }

    @Override
    public float batteryCurrentAmperes() {
        return (float) drawnAmperes;
    }

    @Override
    public float motorCurrentAmperes() {
        return (float) motorAmperes;
    }
}
