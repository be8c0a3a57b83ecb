package lejos.hardware.sensor;

import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;
import lejos.robotics.Color;
import lejos.robotics.ColorIdentifier;
import lejos.robotics.LampController;

/**
 * The NXT colour sensor: modes "ColorID", "Red", "Green", "Blue", "RGB" (four elements, the background last) and "None"
 * (lamps off).
 *
 * <p>Entering a mode that uses all lamps blocks for about a second while the sensor hands over its calibration; other
 * changes take 10 ms.
 */
public class NXTColorSensor extends AnalogSensor implements SensorConstants, LampController, ColorIdentifier {
    /** Wait after a change of lamps, milliseconds. */
    protected static final long SWITCH_DELAY = 10;
    /** {@link Color} numbers by LEGO colour id 0 to 6. */
    protected static int[] colorMap = {
        Color.NONE, Color.BLACK, Color.BLUE, Color.GREEN, Color.YELLOW, Color.RED, Color.WHITE};

    /** Full scale of the sensor's converter. */
    private static final float FULL_SCALE_VOLTS = 3.3f;
    /** Position of the colour id behind the four channels. */
    private static final int ID_INDEX = 4;

    private final float[] volts = new float[ID_INDEX + 1];

    /** Sets the modes and switches all lamps on. */
    protected void init() {
        setModes(new SensorMode[] {
            new ColorIDMode(this),
            new ChannelMode("Red", TYPE_COLORRED, RED_INDEX, 1),
            new ChannelMode("Green", TYPE_COLORGREEN, GREEN_INDEX, 1),
            new ChannelMode("Blue", TYPE_COLORBLUE, BLUE_INDEX, 1),
            new ChannelMode("RGB", TYPE_COLORFULL, RED_INDEX, ID_INDEX),
            new ChannelMode("None", TYPE_COLORNONE, BLANK_INDEX, 1)});
        setFloodlight(Color.WHITE);
    }

    /** A sensor on an open port, which {@link #close()} leaves open; blocks for about a second. */
    public NXTColorSensor(AnalogPort port) {
        super(port);
        init();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks for about a second.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public NXTColorSensor(Port port) {
        super(port);
        init();
    }

    /** Mode "ColorID": a {@link Color} number, −1 for none; brown is not known. */
    public SensorMode getColorIDMode() {
        return getMode(0);
    }

    /** Mode "Red": light with the red lamp on, 0 to 1. */
    public SensorMode getRedMode() {
        return getMode(1);
    }

    /** Mode "Green": light with the green lamp on, 0 to 1. */
    public SensorMode getGreenMode() {
        return getMode(2);
    }

    /** Mode "Blue": light with the blue lamp on, 0 to 1. */
    public SensorMode getBlueMode() {
        return getMode(3);
    }

    /** Mode "RGB": red, green, blue and background, 0 to 1. */
    public SensorMode getRGBMode() {
        return getMode(4);
    }

    /** Mode "None": light with all lamps off, 0 to 1. */
    public SensorMode getAmbientMode() {
        return getMode(5);
    }

    /** Reads all channels in the present lamp mode. */
    protected void readRaw() {
        port.getFloats(volts, 0, volts.length);
    }

    /** Reads all channels with all lamps in turn, entering that mode if needed. */
    protected void readFull() {
        switchType(TYPE_COLORFULL, SWITCH_DELAY);
        readRaw();
    }

    /** Red lamp on, or all lamps off. */
    @Override
    public void setFloodlight(boolean floodlight) {
        setFloodlight(floodlight ? Color.RED : Color.NONE);
    }

    @Override
    public int getFloodlight() {
        switch (currentType) {
            case TYPE_COLORFULL:
                return Color.WHITE;
            case TYPE_COLORRED:
                return Color.RED;
            case TYPE_COLORGREEN:
                return Color.GREEN;
            case TYPE_COLORBLUE:
                return Color.BLUE;
            default:
                return Color.NONE;
        }
    }

    @Override
    public boolean isFloodlightOn() {
        return getFloodlight() != Color.NONE;
    }

    /** Switches the lamps: red, green, blue, white (all in turn) or none; any other colour is refused with false. */
    @Override
    public boolean setFloodlight(int color) {
        switch (color) {
            case Color.RED:
                switchType(TYPE_COLORRED, SWITCH_DELAY);
                return true;
            case Color.GREEN:
                switchType(TYPE_COLORGREEN, SWITCH_DELAY);
                return true;
            case Color.BLUE:
                switchType(TYPE_COLORBLUE, SWITCH_DELAY);
                return true;
            case Color.WHITE:
                switchType(TYPE_COLORFULL, SWITCH_DELAY);
                return true;
            case Color.NONE:
                switchType(TYPE_COLORNONE, SWITCH_DELAY);
                return true;
            default:
                return false;
        }
    }

    /** The colour in view as a {@link Color} number, −1 for none. */
    @Override
    public int getColorID() {
        readFull();
        int id = Math.round(volts[ID_INDEX]);
        return id >= 0 && id < colorMap.length ? colorMap[id] : Color.NONE;
    }

    /** Some neighbouring channels, measured in one lamp mode. */
    private final class ChannelMode implements SensorMode {
        private final String name;
        private final int type;
        private final int first;
        private final int count;

        ChannelMode(String name, int type, int first, int count) {
            this.name = name;
            this.type = type;
            this.first = first;
            this.count = count;
        }

        @Override
        public int sampleSize() {
            return count;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchType(type, SWITCH_DELAY);
            readRaw();
            for (int i = 0; i < count; i++) {
                sample[offset + i] = volts[first + i] / FULL_SCALE_VOLTS;
            }
        }

        @Override
        public String getName() {
            return name;
        }
    }
}
