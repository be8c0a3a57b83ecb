package lejos.hardware.port;

import lejos.internal.ev3.EV3Ports;

/** The four motor ports of the default brick; touching them opens nothing. */
public interface MotorPort {
    /** Port A. */
    Port A = EV3Ports.motorPort(0);
    /** Port B. */
    Port B = EV3Ports.motorPort(1);
    /** Port C. */
    Port C = EV3Ports.motorPort(2);
    /** Port D. */
    Port D = EV3Ports.motorPort(3);
}
