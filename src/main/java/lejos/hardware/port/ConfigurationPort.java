package lejos.hardware.port;

import lejos.hardware.sensor.EV3SensorConstants;

/** A port opened to find out what is plugged in. */
public interface ConfigurationPort extends IOPort, EV3SensorConstants {
    /** How the device is wired: one of the {@code CONN_…} numbers. */
    int getPortType();

    /** What the device is: one of the {@code TYPE_…} numbers of {@link EV3SensorConstants}. */
    int getDeviceType();
}
