package brickless.hardware;

/** The I²C bus of an input port. */
public interface I2cChannel {
    /** Outcome of a transaction. */
    enum Status { OK, BUSY, NO_ANSWER }

    /** Selects 10 or 100 kHz and 0 or 9 V on pin 1. */
    void configure(boolean fast, boolean nineVolts);

    /**
     * Writes, then reads, blocking for the time the bus needs.
     *
     * @param address 8-bit address with bit 0 clear
     * @param write bytes to write, may be null when {@code writeLength} is 0
     * @param read array to fill, may be null when {@code readLength} is 0
     */
    Status transaction(int address, byte[] write, int writeOffset, int writeLength, byte[] read, int readOffset,
            int readLength);
}
