package lejos.hardware.port;

/** A port opened as an I²C bus. */
public interface I2CPort extends IOPort, BasicSensorPort {
    /** Longest write and longest read of one transaction, bytes. */
    int MAX_IO = 32;

    /**
     * Writes, then reads; blocks for the time the bus needs.
     *
     * @param deviceAddress 8-bit address, lowest bit 0
     * @param writeBuf bytes to write, may be null when {@code writeLen} is 0
     * @param readBuf array to fill, may be null when {@code readLen} is 0
     * @throws I2CException if nothing answers or the bus is busy
     */
    void i2cTransaction(int deviceAddress, byte[] writeBuf, int writeOffset, int writeLen, byte[] readBuf,
            int readOffset, int readLen);
}
