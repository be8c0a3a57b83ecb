package programs.fitted.owndrivers;

import lejos.hardware.port.Port;
import lejos.hardware.sensor.UARTSensor;

/** The EV3 distance sensor in its own numbers. */
class SerialSonar extends UARTSensor {
    SerialSonar(Port port) {
        super(port, 0);
    }

    int millimetres() {
        return port.getShort();
    }
}
