package brickless.device.sensor;

import brickless.hardware.SensorSocket.Wiring;

/** A device that answers with a voltage. */
abstract class AnalogSensor extends SensorModel {
    /** Voltage of an open pin 1: a pull-up in the brick. */
    static final double PULL_UP_VOLTS = 5;
    /** Period of fresh converter values: a noise value lasts this long, nanoseconds. */
    static final long SAMPLE_NANOS = 3_000_000;
    static final float[] NO_COLOURS = {};

    AnalogSensor(SensorSite site) {
        super(site);
    }

    @Override
    final Wiring wiring() {
        return Wiring.ANALOG;
    }

    abstract double pin1Volts(long nowNanos);

    double pin6Volts(long nowNanos) {
        return 0;
    }

    /** The pin drive changed to a type of {@code SensorConstants}. */
    void setType(int type) {
        // Only sensors with a lamp or several ranges care.
    }

    float[] colourVolts(long nowNanos) {
        return NO_COLOURS;
    }
}
