package lejos.hardware.sensor;

import java.util.ArrayList;
import java.util.NoSuchElementException;
import lejos.hardware.Device;

/**
 * The list of modes that every sensor has. Drivers call {@link #setModes(SensorMode[])} once, when they are
 * constructed.
 */
public class BaseSensor extends Device implements SensorModes {
    /** Index of the mode that the sensor object stands for. */
    protected int currentMode;
    /** All modes. */
    protected SensorMode[] modes;

    private ArrayList<String> names;

    /** A sensor without modes yet. */
    public BaseSensor() {}

    /** Sets the modes, of which the first becomes the current one. */
    protected void setModes(SensorMode[] m) {
        modes = m;
        currentMode = 0;
        names = null;
    }

    @Override
    public ArrayList<String> getAvailableModes() {
        if (names == null) {
            names = new ArrayList<>(modes.length);
            for (SensorMode mode : modes) {
                names.add(mode.getName());
            }
        }
        return names;
    }

    @Override
    public SensorMode getMode(int mode) {
        if (mode < 0) {
            throw new IllegalArgumentException("Invalid mode " + mode, listOfModes());
        }
        return mode < modes.length ? modes[mode] : null;
    }

    @Override
    public SensorMode getMode(String modeName) {
        int index = indexOf(modeName);
        if (index < 0) {
            throw new IllegalArgumentException("No such mode " + modeName, listOfModes());
        }
        return modes[index];
    }

    private int indexOf(String modeName) {
        for (int i = 0; i < modes.length; i++) {
            if (modes[i].getName().equals(modeName)) {
                return i;
            }
        }
        return -1;
    }

    private Throwable listOfModes() {
        return new NoSuchElementException(getClass().getSimpleName() + " has the modes "
                + String.join(", ", getAvailableModes()));
    }

    @Override
    public String getName() {
        return modes[currentMode].getName();
    }

    @Override
    public int sampleSize() {
        return modes[currentMode].sampleSize();
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        modes[currentMode].fetchSample(sample, offset);
    }

    @Override
    public void setCurrentMode(int mode) {
        if (mode < 0 || mode >= modes.length) {
            throw new IllegalArgumentException("Invalid mode " + mode, listOfModes());
        }
        currentMode = mode;
    }

    @Override
    public void setCurrentMode(String modeName) {
        int index = indexOf(modeName);
        if (index < 0) {
            throw new IllegalArgumentException("Invalid mode " + modeName, listOfModes());
        }
        currentMode = index;
    }

    @Override
    public int getCurrentMode() {
        return currentMode;
    }

    @Override
    public int getModeCount() {
        return modes.length;
    }
}
