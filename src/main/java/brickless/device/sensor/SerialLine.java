package brickless.device.sensor;

import brickless.hardware.UartChannel;
import brickless.kernel.Costs;

/** The serial side of a port. */
final class SerialLine implements UartChannel {
    /** Time until a device that has been dark sends data: assumption (0.1 to 3 s on a brick). */
    private static final long START_NANOS = 100_000_000;
    /** Time until the brick knows that nobody answers. */
    private static final long NO_ANSWER_NANOS = 30_000_000;

    private final SensorPortDevice port;
    private final byte[] message = new byte[UartSensor.LONGEST_MESSAGE];

    SerialLine(SensorPortDevice port) {
        this.port = port;
    }

    @Override
    public boolean initialise(int mode) {
        return change(mode, true);
    }

    @Override
    public boolean setMode(int mode) {
        return change(mode, false);
    }

    private boolean change(int mode, boolean restart) {
        port.charge(Costs.SENSOR_READ_NANOS);
        if (!(port.sensor() instanceof UartSensor sensor) || !sensor.has(mode)) {
            port.pause(NO_ANSWER_NANOS);
            return false;
        }
        if (sensor.mode() == UartSensor.DARK || restart) {
            port.pause(START_NANOS);
        } else if (sensor.mode() != mode) {
            port.pause(sensor.mode(mode).switchNanos());
        } else {
            return true;
        }
        long now = port.nowNanos();
        synchronized (port.lock()) {
            sensor.select(mode, now);
        }
        return true;
    }

    @Override
    public void reset() {
        port.charge(Costs.SENSOR_READ_NANOS);
        port.release();
    }

    @Override
    public int read(byte[] destination, int offset, int length) {
        port.charge(Costs.SENSOR_READ_NANOS);
        long now = port.nowNanos();
        synchronized (port.lock()) {
            if (!(port.sensor() instanceof UartSensor sensor) || sensor.mode() == UartSensor.DARK) {
                return 0;
            }
            sensor.message(now, message);
            int count = Math.min(length, sensor.mode(sensor.mode()).bytes());
            System.arraycopy(message, 0, destination, offset, count);
            return count;
        }
    }

    @Override
    public int write(byte[] source, int offset, int length) {
        port.charge(Costs.SENSOR_READ_NANOS);
        return port.sensor() instanceof UartSensor ? length : 0;
    }

    @Override
    public String modeName(int mode) {
        return port.sensor() instanceof UartSensor sensor && sensor.has(mode) ? sensor.mode(mode).name() : "Unknown";
    }
}
