package lejos.hardware.sensor;

import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.Port;
import lejos.robotics.Color;
import lejos.robotics.LampController;

/**
 * The NXT light sensor: mode 0 "Red" with its lamp on, mode 1 "Ambient" with its lamp off; values 0 (dark) to 1.
 *
 * <p>A fetch sets the lamp that its mode needs and waits 10 ms when it has to change.
 */
public class NXTLightSensor extends AnalogSensor implements LampController, SensorConstants {
    /** Wait after the lamp has changed, milliseconds. */
    protected static final long SWITCH_DELAY = 10;

    /** Sets the modes and switches the lamp on. */
    protected void init() {
        setModes(new SensorMode[] {
            new LightMode(this, "Red", TYPE_LIGHT_ACTIVE), new LightMode(this, "Ambient", TYPE_LIGHT_INACTIVE)});
        setFloodlight(true);
    }

    /** A sensor on an open port, which {@link #close()} leaves open; its lamp is on. */
    public NXTLightSensor(AnalogPort port) {
        super(port);
        init();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor; its lamp is on.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public NXTLightSensor(Port port) {
        super(port);
        init();
    }

    @Override
    public void setFloodlight(boolean floodlight) {
        switchType(floodlight ? TYPE_LIGHT_ACTIVE : TYPE_LIGHT_INACTIVE, SWITCH_DELAY);
    }

    /** Switches the lamp: {@link Color#RED} on, {@link Color#NONE} off; any other colour is refused with false. */
    @Override
    public boolean setFloodlight(int color) {
        if (color != Color.RED && color != Color.NONE) {
            return false;
        }
        setFloodlight(color == Color.RED);
        return true;
    }

    @Override
    public int getFloodlight() {
        return isFloodlightOn() ? Color.RED : Color.NONE;
    }

    @Override
    public boolean isFloodlightOn() {
        return currentType == TYPE_LIGHT_ACTIVE;
    }

    /** Mode "Red": reflected light. */
    public SensorMode getRedMode() {
        return getMode(0);
    }

    /** Mode "Ambient": light of the surroundings. */
    public SensorMode getAmbientMode() {
        return getMode(1);
    }
}
