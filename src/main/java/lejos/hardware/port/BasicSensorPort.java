package lejos.hardware.port;

import lejos.hardware.sensor.SensorConstants;

/** Type and mode of an opened sensor port. */
public interface BasicSensorPort extends SensorConstants {
    /** The mode set last, 0 at first. */
    int getMode();

    /** Always 0: the type set last is not remembered. */
    int getType();

    /**
     * Selects a mode of the device.
     *
     * @return false if the device has no such mode
     */
    boolean setMode(int mode);

    /**
     * Selects how the pins are driven.
     *
     * @param type one of the {@code TYPE_…} numbers of {@link SensorConstants}
     * @return false if the port cannot do that
     */
    boolean setType(int type);

    /**
     * Sets type and mode.
     *
     * @return always true, even if one of them was refused
     * @deprecated call {@link #setType(int)} and {@link #setMode(int)} and look at their results
     */
    @Deprecated
    boolean setTypeAndMode(int type, int mode);
}
