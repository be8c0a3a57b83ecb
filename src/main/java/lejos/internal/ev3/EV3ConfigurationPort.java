package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.SensorSocket;
import lejos.hardware.port.ConfigurationPort;

/**
 * A port opened to find out what is plugged in. Virtual devices are identified at once; the original needs up to 2 s.
 */
public class EV3ConfigurationPort extends EV3IOPort implements ConfigurationPort {
    /** A port that is not open yet. */
    public EV3ConfigurationPort() {}

    @Override
    protected void connect() {}

    @Override
    protected void disconnect() {}

    @Override
    public int getPortType() {
        requireOpen();
        if (typ == EV3Port.MOTOR_PORT) {
            return motor().equals("none") ? CONN_NONE : CONN_OUTPUT_TACHO;
        }
        SensorSocket sensor = sensor();
        switch (sensor.wiring()) {
            case UART:
                return CONN_INPUT_UART;
            case I2C:
                return CONN_NXT_IIC;
            case ANALOG:
                return analogueConnection(sensor.deviceType());
            default:
                return CONN_NONE;
        }
    }

    @Override
    public int getDeviceType() {
        requireOpen();
        if (typ == EV3Port.SENSOR_PORT) {
            return sensor().deviceType();
        }
        switch (motor()) {
            case "none":
                return TYPE_NONE;
            case "ev3-medium":
                return TYPE_MINITACHO;
            default:
                return TYPE_TACHO;
        }
    }

    private static int analogueConnection(int deviceType) {
        switch (deviceType) {
            case TYPE_NXT_COLOR:
                return CONN_NXT_COLOR;
            case TYPE_NXT_TOUCH, TYPE_NXT_LIGHT, TYPE_NXT_SOUND:
                return CONN_NXT_DUMB;
            default:
                return CONN_INPUT_DUMB;
        }
    }

    private SensorSocket sensor() {
        return BrickAccess.brick().sensor(port);
    }

    private String motor() {
        return BrickAccess.brick().motor(port).connected();
    }

    @Override
    String describePlug() {
        return typ == EV3Port.SENSOR_PORT
                ? SensorPlug.describe(getName(), sensor(), lejosClass(), user())
                : motor() + " is plugged into " + getName();
    }
}
