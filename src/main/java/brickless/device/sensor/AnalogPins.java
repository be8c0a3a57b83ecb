package brickless.device.sensor;

import brickless.hardware.AnalogChannel;
import brickless.kernel.Costs;

/** The analogue side of a port. */
final class AnalogPins implements AnalogChannel {
    private static final double REFERENCE_VOLTS = 5;
    private static final double LARGEST_COUNT = 4095;
    private static final long FRESH_SAMPLE_NANOS = 3_000_000;

    private final SensorPortDevice port;

    AnalogPins(SensorPortDevice port) {
        this.port = port;
    }

    @Override
    public double pin1Volts() {
        port.charge(Costs.SENSOR_READ_NANOS);
        long now = port.nowNanos();
        synchronized (port.lock()) {
            return quantised(port.sensor() instanceof AnalogSensor sensor ? sensor.pin1Volts(now) : REFERENCE_VOLTS);
        }
    }

    @Override
    public double pin6Volts() {
        port.charge(Costs.SENSOR_READ_NANOS);
        long now = port.nowNanos();
        synchronized (port.lock()) {
            return quantised(port.sensor() instanceof AnalogSensor sensor ? sensor.pin6Volts(now) : 0);
        }
    }

    private static double quantised(double volts) {
        return Math.round(volts / REFERENCE_VOLTS * LARGEST_COUNT) / LARGEST_COUNT * REFERENCE_VOLTS;
    }

    @Override
    public boolean setType(int type) {
        port.charge(Costs.SENSOR_READ_NANOS);
        if (type < 0 || type == 12 || type > 17) {
            return false;
        }
        synchronized (port.lock()) {
            if (port.sensor() instanceof AnalogSensor sensor) {
                sensor.setType(type);
            }
        }
        port.pause(FRESH_SAMPLE_NANOS);
        return true;
    }

    @Override
    public float[] colourVolts() {
        port.charge(Costs.SENSOR_READ_NANOS);
        long now = port.nowNanos();
        synchronized (port.lock()) {
            return port.sensor() instanceof AnalogSensor sensor ? sensor.colourVolts(now) : AnalogSensor.NO_COLOURS;
        }
    }
}
