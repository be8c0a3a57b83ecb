package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.robotics.Color;
import lejos.robotics.LampController;

/** The RCX light sensor: mode 0 "Red" with its lamp on, mode 1 "Ambient" with its lamp off; values 0 (dark) to 1. */
public class RCXLightSensor extends AnalogSensor implements SensorConstants, LampController {
    /**
     * A sensor on a port that is opened now and closed with the sensor; its lamp is on.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public RCXLightSensor(Port port) {
        super(port);
        init();
    }

    /** Sets the modes and switches the lamp on. */
    protected void init() {
        setModes(new SensorMode[] {
            new LightMode(this, "Red", TYPE_REFLECTION), new LightMode(this, "Ambient", TYPE_CUSTOM)});
        setFloodlight(true);
    }

    @Override
    public int getFloodlight() {
        return isFloodlightOn() ? Color.RED : Color.NONE;
    }

    @Override
    public boolean isFloodlightOn() {
        return currentType == TYPE_REFLECTION;
    }

    @Override
    public void setFloodlight(boolean floodlight) {
        switchType(floodlight ? TYPE_REFLECTION : TYPE_CUSTOM, LightMode.SWITCH_DELAY);
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

    /** Mode "Red": reflected light. */
    public SensorMode getRedMode() {
        return getMode(0);
    }

    /** Mode "Ambient": light of the surroundings. */
    public SensorMode getAmbientMode() {
        return getMode(1);
    }
}
