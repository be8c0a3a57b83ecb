package lejos.hardware.port;

import lejos.internal.ev3.EV3Ports;

/** The four sensor ports of the default brick; touching them opens nothing. */
public interface SensorPort {
    /** Port S1. */
    Port S1 = EV3Ports.sensorPort(0);
    /** Port S2. */
    Port S2 = EV3Ports.sensorPort(1);
    /** Port S3. */
    Port S3 = EV3Ports.sensorPort(2);
    /** Port S4. */
    Port S4 = EV3Ports.sensorPort(3);
}
