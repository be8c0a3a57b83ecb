package programs.fitted.owndrivers;

import lejos.hardware.port.Port;
import lejos.hardware.sensor.AnalogSensor;

/** A switch to earth at pin 1. */
class Switch extends AnalogSensor {
    Switch(Port port) {
        super(port);
    }

    boolean closed() {
        return port.getPin1() < 2.5f;
    }
}
