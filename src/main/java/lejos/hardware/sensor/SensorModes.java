package lejos.hardware.sensor;

import java.util.ArrayList;

/** A sensor with its modes; itself a sample provider for its current mode, at first the mode with index 0. */
public interface SensorModes extends SensorMode {
    /** Names of all modes in the order of their indices. */
    ArrayList<String> getAvailableModes();

    /**
     * A mode by index.
     *
     * @return the mode, or null if the index is too large
     * @throws IllegalArgumentException if the index is negative
     */
    SensorMode getMode(int mode);

    /**
     * A mode by its exact name.
     *
     * @throws IllegalArgumentException if there is no such mode
     */
    SensorMode getMode(String modeName);

    /**
     * Selects the mode that the sensor object itself stands for; the device switches with the next fetch.
     *
     * @throws IllegalArgumentException if there is no such mode
     */
    void setCurrentMode(int mode);

    /**
     * Selects the mode that the sensor object itself stands for; the device switches with the next fetch.
     *
     * @throws IllegalArgumentException if there is no such mode
     */
    void setCurrentMode(String modeName);

    /** Index of the current mode. */
    int getCurrentMode();

    /** Number of modes. */
    int getModeCount();
}
