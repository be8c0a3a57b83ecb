package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.hardware.port.UARTPort;
import lejos.robotics.Color;
import lejos.robotics.ColorIdentifier;
import lejos.robotics.LampController;

/**
 * The EV3 colour sensor: mode 0 "ColorID", mode 1 "Red", mode 2 "RGB", mode 3 "Ambient".
 *
 * <p>The lamp belongs to the hardware mode: it cannot be set independently of what is measured, and the next fetch
 * turns it on again.
 */
public class EV3ColorSensor extends UARTSensor implements LampController, ColorIdentifier {
    /** {@link Color} numbers by LEGO colour id 0 to 7. */
    protected static int[] colorMap = {
        Color.NONE, Color.BLACK, Color.BLUE, Color.GREEN, Color.YELLOW, Color.RED, Color.WHITE, Color.BROWN};
    /** Kept for subclasses; the device itself tells when it is ready. */
    protected static final int SWITCH_DELAY = 250;
    /** The device is being restarted; lamp off. */
    protected static final int COL_RESET = -1;
    /** Hardware mode: reflected red light. */
    protected static final int COL_REFLECT = 0;
    /** Hardware mode: ambient light. */
    protected static final int COL_AMBIENT = 1;
    /** Hardware mode: colour id. */
    protected static final int COL_COLOR = 2;
    /** Hardware mode: reflected light, raw. */
    protected static final int COL_REFRAW = 3;
    /** Hardware mode: three channels, raw. */
    protected static final int COL_RGBRAW = 4;
    /** Hardware mode: calibration. */
    protected static final int COL_CAL = 5;
    /** Colour of the lamp by hardware mode + 1. */
    protected static final int[] lightColor = {
        Color.NONE, Color.RED, Color.BLUE, Color.WHITE, Color.WHITE, Color.WHITE, Color.WHITE};

    private static final float RAW_FULL_SCALE = 1020;
    private static final float PERCENT = 100;

    /** The channels read last. */
    protected short[] raw = new short[3];

    /** Sets the modes. */
    protected void initModes() {
        setModes(new SensorMode[] {
            new ColorIDMode(this),
            new PercentMode("Red", COL_REFLECT),
            new RGBMode(),
            new PercentMode("Ambient", COL_AMBIENT)});
    }

    /**
     * A sensor on an open port, which {@link #close()} leaves open; its red lamp is on.
     *
     * @throws lejos.hardware.DeviceException if no serial sensor answers
     */
    public EV3ColorSensor(UARTPort port) {
        super(port, COL_REFLECT);
        initModes();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks until it sends data. Its red lamp is on.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if no serial sensor answers
     */
    public EV3ColorSensor(Port port) {
        super(port, COL_REFLECT);
        initModes();
    }

    /** The colour in view as a {@link Color} number; may block for a switch of mode. */
    @Override
    public int getColorID() {
        switchMode(COL_COLOR, SWITCH_DELAY);
        int id = port.getByte() & 0xff;
        return id < colorMap.length ? colorMap[id] : Color.NONE;
    }

    /** Red lamp (and mode) on, or sensor restarted with the lamp off. */
    @Override
    public void setFloodlight(boolean floodlight) {
        setFloodlight(floodlight ? Color.RED : Color.NONE);
    }

    @Override
    public boolean isFloodlightOn() {
        return getFloodlight() != Color.NONE;
    }

    /** Colour of the lamp by the present hardware mode. */
    @Override
    public int getFloodlight() {
        return lightColor[currentMode + 1];
    }

    /**
     * Switches to a mode with the wanted lamp: red, white or blue; {@link Color#NONE} restarts the sensor.
     *
     * @return true
     * @throws IllegalArgumentException if there is no such lamp
     */
    @Override
    public boolean setFloodlight(int color) {
        switch (color) {
            case Color.BLUE:
                switchMode(COL_AMBIENT, SWITCH_DELAY);
                return true;
            case Color.WHITE:
                switchMode(COL_COLOR, SWITCH_DELAY);
                return true;
            case Color.RED:
                switchMode(COL_REFLECT, SWITCH_DELAY);
                return true;
            case Color.NONE:
                switchMode(COL_RESET, SWITCH_DELAY);
                return true;
            default:
                throw new IllegalArgumentException("Invalid color specified");
        }
    }

    /** Mode "ColorID": a {@link Color} number, −1 for none. */
    public SensorMode getColorIDMode() {
        return getMode(0);
    }

    /** Mode "Red": share of its red light that comes back, 0 to 1. */
    public SensorMode getRedMode() {
        return getMode(1);
    }

    /** Mode "Ambient": light of the surroundings, 0 to 1. */
    public SensorMode getAmbientMode() {
        return getMode(3);
    }

    /** Mode "RGB": red, green and blue, 0 to 1, not white-balanced. */
    public SensorMode getRGBMode() {
        return getMode(2);
    }

    /** A mode whose device value is a percentage. */
    private final class PercentMode implements SensorMode {
        private final String name;
        private final int hardwareMode;

        PercentMode(String name, int hardwareMode) {
            this.name = name;
            this.hardwareMode = hardwareMode;
        }

        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(hardwareMode, SWITCH_DELAY);
            sample[offset] = (port.getByte() & 0xff) / PERCENT;
        }

        @Override
        public String getName() {
            return name;
        }
    }

    private final class RGBMode implements SensorMode {
        @Override
        public int sampleSize() {
            return raw.length;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(COL_RGBRAW, SWITCH_DELAY);
            port.getShorts(raw, 0, raw.length);
            for (int i = 0; i < raw.length; i++) {
                sample[offset + i] = raw[i] / RAW_FULL_SCALE;
            }
        }

        @Override
        public String getName() {
            return "RGB";
        }
    }
}
