package brickless.device.sensor;

import brickless.hardware.SensorSocket.Wiring;

/**
 * A device on the I²C bus: bytes in numbered registers, where the first eight-byte texts tell version, maker and
 * product.
 */
abstract class RegisterSensor extends SensorModel {
    private static final int DEVICE = 123;
    private static final int VERSION = 0x00;
    private static final int VENDOR = 0x08;
    private static final int PRODUCT = 0x10;
    private static final int TEXT_LENGTH = 8;
    private static final int REGISTERS = 0x100;

    private final int address;
    private final byte[] registers = new byte[REGISTERS];

    /**
     * A device with its three texts, of which at most eight characters are told.
     *
     * @param address on the bus, 8-bit form
     */
    RegisterSensor(SensorSite site, int address, String version, String vendor, String product) {
        super(site);
        this.address = address;
        text(VERSION, version);
        text(VENDOR, vendor);
        text(PRODUCT, product);
    }

    private void text(int register, String value) {
        for (int i = 0; i < Math.min(TEXT_LENGTH, value.length()); i++) {
            registers[register + i] = (byte) value.charAt(i);
        }
    }

    @Override
    final Wiring wiring() {
        return Wiring.I2C;
    }

    @Override
    final int deviceType() {
        return DEVICE;
    }

    /** Address on the bus, 8-bit form. */
    final int address() {
        return address;
    }

    /** The value of a register, 0 to 255. */
    final int register(int number) {
        return registers[number] & 0xff;
    }

    /** Sets a register, as the device itself does. */
    final void setRegister(int number, int value) {
        registers[number] = (byte) value;
    }

    /** Whether the brick can write a register. */
    abstract boolean writable(int register);

    /** The brick wrote a register that can be written. */
    abstract void written(int register, long nowNanos);

    /** The brick is about to read; registers that are computed only when asked for are set now. */
    void aboutToRead(long nowNanos) {
        // Most devices keep their registers up to date.
    }

    /** A write: the first byte selects a register, the others are stored from there on. */
    final void write(byte[] bytes, int offset, int length, long nowNanos) {
        for (int i = 1; i < length; i++) {
            int register = (bytes[offset] & 0xff) + i - 1;
            if (register < REGISTERS && writable(register)) {
                registers[register] = bytes[offset + i];
                written(register, nowNanos);
            }
        }
    }

    /** A read of registers from the one selected; there is nothing behind the last one. */
    final void read(int register, byte[] bytes, int offset, int length, long nowNanos) {
        aboutToRead(nowNanos);
        for (int i = 0; i < length; i++) {
            bytes[offset + i] = register + i < REGISTERS ? registers[register + i] : 0;
        }
    }
}
