package brickless.device.sensor;

import brickless.hardware.I2cChannel;
import brickless.kernel.Costs;

/** The I²C side of a port. */
final class RegisterBus implements I2cChannel {
    private final SensorPortDevice port;

    RegisterBus(SensorPortDevice port) {
        this.port = port;
    }

    @Override
    public void configure(boolean fast, boolean nineVolts) {
        // The models answer at any speed and need no supply.
    }

    @Override
    public Status transaction(int address, byte[] write, int writeOffset, int writeLength, byte[] read,
            int readOffset,
            int readLength) {
        port.occupy(Costs.I2C_TRANSACTION_NANOS);
        long now = port.nowNanos();
        synchronized (port.lock()) {
            if (!(port.sensor() instanceof RegisterSensor sensor) || address != sensor.address()) {
                return Status.NO_ANSWER;
            }
            if (writeLength > 0) {
                sensor.write(write, writeOffset, writeLength, now);
            }
            if (readLength > 0) {
                sensor.read(writeLength > 0 ? write[writeOffset] & 0xff : 0, read, readOffset, readLength, now);
            }
            return Status.OK;
        }
    }
}
