package lejos.internal.ev3;

import lejos.hardware.DeviceException;
import lejos.hardware.port.AnalogPort;
import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.ConfigurationPort;
import lejos.hardware.port.I2CPort;
import lejos.hardware.port.IOPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.TachoMotorPort;
import lejos.hardware.port.UARTPort;

/** One socket of the EV3, closed until a program opens it. */
public class EV3Port implements Port {
    /** Kind of the ports S1 to S4. */
    public static final int SENSOR_PORT = 0;
    /** Kind of the ports A to D. */
    public static final int MOTOR_PORT = 1;

    /** The port's name, e.g. {@code "S1"}. */
    protected String name;
    /** {@link #SENSOR_PORT} or {@link #MOTOR_PORT}. */
    protected int typ;
    /** 0 to 3. */
    protected int portNum;

    /**
     * A port.
     *
     * @param name its name
     * @param typ {@link #SENSOR_PORT} or {@link #MOTOR_PORT}
     * @param portNum 0 to 3
     */
    public EV3Port(String name, int typ, int portNum) {
        this.name = name;
        this.typ = typ;
        this.portNum = portNum;
    }

    @Override
    public String getName() {
        return name;
    }

    @Override
    public <T extends IOPort> T open(Class<T> portclass) {
        EV3IOPort opened = typ == SENSOR_PORT ? sensorPort(portclass) : motorPort(portclass);
        if (opened == null) {
            throw new IllegalArgumentException("Invalid port interface", refusal(portclass));
        }
        if (!opened.open(typ, portNum, this)) {
            throw new DeviceException("unable to open port", EV3IOPort.occupation(typ, portNum));
        }
        return portclass.cast(opened);
    }

    private static EV3IOPort sensorPort(Class<?> wanted) {
        if (wanted == UARTPort.class) {
            return new EV3UARTPort();
        }
        if (wanted == AnalogPort.class) {
            return new EV3AnalogPort();
        }
        if (wanted == I2CPort.class) {
            return new EV3I2CPort();
        }
        return wanted == ConfigurationPort.class ? new EV3ConfigurationPort() : null;
    }

    private static EV3IOPort motorPort(Class<?> wanted) {
        if (wanted == TachoMotorPort.class || wanted == BasicMotorPort.class) {
            return new EV3MotorPort();
        }
        return wanted == ConfigurationPort.class ? new EV3ConfigurationPort() : null;
    }

    private Throwable refusal(Class<?> wanted) {
        String kind = typ == SENSOR_PORT ? " is a sensor port (motors go into A to D)"
                : " is a motor port (sensors go into S1 to S4)";
        return new IllegalStateException(name + kind + " and cannot be opened as "
                + (wanted == null ? "null" : wanted.getSimpleName()));
    }

    @Override
    public String toString() {
        return name;
    }
}
