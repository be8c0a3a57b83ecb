package programs.fitted.subclasses;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;

/** The colour sensor, always at the same port. */
class Eye extends EV3ColorSensor {
    Eye() {
        super(SensorPort.S4);
    }

    float red() {
        float[] sample = new float[1];
        getRedMode().fetchSample(sample, 0);
        return sample[0];
    }
}
