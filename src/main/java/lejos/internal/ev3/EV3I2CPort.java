package lejos.internal.ev3;

import brickless.hardware.I2cChannel;
import lejos.hardware.port.I2CException;
import lejos.hardware.port.I2CPort;

/** An input port opened as an I²C bus. */
public class EV3I2CPort extends EV3SensorIOPort implements I2CPort {
    /** A port that is not open yet. */
    public EV3I2CPort() {}

    @Override
    public boolean setType(int type) {
        switch (type) {
            case TYPE_LOWSPEED, TYPE_LOWSPEED_9V, TYPE_HIGHSPEED, TYPE_HIGHSPEED_9V:
                boolean fast = type == TYPE_HIGHSPEED || type == TYPE_HIGHSPEED_9V;
                boolean nineVolts = type == TYPE_LOWSPEED_9V || type == TYPE_HIGHSPEED_9V;
                socket().i2c().configure(fast, nineVolts);
                return true;
            default:
                return false;
        }
    }

    @Override
    public synchronized void i2cTransaction(int deviceAddress, byte[] writeBuf, int writeOffset, int writeLen,
            byte[] readBuf, int readOffset, int readLen) {
        if (writeLen > MAX_IO || readLen > MAX_IO) {
            throw new IllegalArgumentException("an I2C transaction moves at most " + MAX_IO + " bytes each way");
        }
        I2cChannel.Status status = socket().i2c()
                .transaction(deviceAddress, writeBuf, writeOffset, writeLen, readBuf, readOffset, readLen);
        switch (status) {
            case OK:
                return;
            case BUSY:
                throw new I2CException("I2C Bus busy");
            default:
                throw new I2CException("I2C I/O error", EV3Ports.mismatch(this));
        }
    }
}
