package lejos.hardware.sensor;

import lejos.hardware.port.I2CException;
import lejos.hardware.port.I2CPort;
import lejos.hardware.port.Port;
import lejos.internal.ev3.EV3Ports;

/** Base of sensors on an I²C bus: registers are read and written by number, failed transactions repeated. */
public class I2CSensor extends BaseSensor implements SensorConstants {
    /** Register of the version text. */
    protected static final byte REG_VERSION = 0x00;
    /** Register of the maker's name. */
    protected static final byte REG_VENDOR_ID = 0x08;
    /** Register of the product's name. */
    protected static final byte REG_PRODUCT_ID = 0x10;
    /** 8-bit address that most sensors have. */
    protected static final int DEFAULT_I2C_ADDRESS = 0x02;

    private static final int DEFAULT_RETRIES = 3;
    private static final int ID_LENGTH = 8;

    /** The bus. */
    protected I2CPort port;
    /** 8-bit address, lowest bit 0. */
    protected int address;
    /** How often a transaction is tried. */
    protected int retryCount = DEFAULT_RETRIES;

    private final byte[] outgoing = new byte[I2CPort.MAX_IO];

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @param address 8-bit address, lowest bit 0
     */
    public I2CSensor(I2CPort port, int address) {
        this.port = port;
        this.address = address;
        EV3Ports.announce(port, this);
    }

    /** A sensor with the usual address on an open port, which {@link #close()} leaves open. */
    public I2CSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor.
     *
     * @param address 8-bit address, lowest bit 0
     * @param type one of the I²C types of {@link SensorConstants}
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a sensor port, or not an I²C type
     */
    public I2CSensor(Port port, int address, int type) {
        this(port.open(I2CPort.class), address);
        releaseOnClose(this.port);
        if (!this.port.setType(type)) {
            this.port.close();
            throw new IllegalArgumentException("Invalid sensor mode");
        }
    }

    /**
     * A sensor with the usual address at 10 kHz on a port that is opened now and closed with the sensor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public I2CSensor(Port port) {
        this(port, DEFAULT_I2C_ADDRESS, TYPE_LOWSPEED);
    }

    /**
     * A sensor at 10 kHz on a port that is opened now and closed with the sensor.
     *
     * @param address 8-bit address, lowest bit 0
     * @throws lejos.hardware.DeviceException if the port is open already
     */
    public I2CSensor(Port port, int address) {
        this(port, address, TYPE_LOWSPEED);
    }

    /**
     * Sets how often a transaction is tried.
     *
     * @throws IllegalArgumentException if it is not at least 1
     */
    public void setRetryCount(int newRetryCount) {
        if (newRetryCount <= 0) {
            throw new IllegalArgumentException("Invalid retry count " + newRetryCount);
        }
        retryCount = newRetryCount;
    }

    /** How often a transaction is tried. */
    public int getRetryCount() {
        return retryCount;
    }

    /** Reads registers into the beginning of a buffer. */
    public void getData(int register, byte[] buf, int len) {
        getData(register, buf, 0, len);
    }

    /**
     * Reads registers.
     *
     * @param register number of the first register
     * @throws I2CException if no try succeeded
     */
    public synchronized void getData(int register, byte[] buf, int offset, int len) {
        outgoing[0] = (byte) register;
        transact(1, buf, offset, len);
    }

    /** Writes registers from the beginning of a buffer. */
    public void sendData(int register, byte[] buf, int len) {
        sendData(register, buf, 0, len);
    }

    /**
     * Writes registers.
     *
     * @param register number of the first register
     * @throws IllegalArgumentException if {@code len} is 32 or more
     * @throws I2CException if no try succeeded
     */
    public synchronized void sendData(int register, byte[] buf, int offset, int len) {
        if (len >= I2CPort.MAX_IO) {
            throw new IllegalArgumentException("Invalid buffer length");
        }
        outgoing[0] = (byte) register;
        System.arraycopy(buf, offset, outgoing, 1, len);
        transact(len + 1, null, 0, 0);
    }

    /**
     * Writes one register.
     *
     * @throws I2CException if no try succeeded
     */
    public synchronized void sendData(int register, byte value) {
        sendData(register, new byte[] {value}, 0, 1);
    }

    private void transact(int writeLength, byte[] read, int offset, int readLength) {
        I2CException failure = null;
        for (int tries = 0; tries < retryCount; tries++) {
            try {
                port.i2cTransaction(address, outgoing, 0, writeLength, read, offset, readLength);
                return;
            } catch (I2CException e) {
                failure = e;
            }
        }
        throw failure;
    }

    /** The version text of the sensor; empty if it does not answer. */
    public String getVersion() {
        return fetchString(REG_VERSION, ID_LENGTH);
    }

    /** The maker's name as the sensor tells it; empty if it does not answer. */
    public String getVendorID() {
        return fetchString(REG_VENDOR_ID, ID_LENGTH);
    }

    /** The product's name as the sensor tells it; empty if it does not answer. */
    public String getProductID() {
        return fetchString(REG_PRODUCT_ID, ID_LENGTH);
    }

    /**
     * Reads a text of at most {@code len} characters, up to the first NUL, without blanks around it; empty if nothing
     * answers.
     */
    protected String fetchString(byte reg, int len) {
        byte[] text = new byte[len];
        try {
            getData(reg, text, len);
        } catch (I2CException e) {
            return "";
        }
        StringBuilder characters = new StringBuilder();
        for (int i = 0; i < len && text[i] != 0; i++) {
            characters.append((char) (text[i] & 0xff));
        }
        return characters.toString().trim();
    }

    /**
     * Changes the address.
     *
     * @param addr 8-bit address, lowest bit 0
     * @throws IllegalArgumentException if the <em>present</em> address is odd (as the original checks it)
     * @deprecated give the address to the constructor
     */
    @Deprecated
    public void setAddress(int addr) {
        if ((address & 1) != 0) {
            throw new IllegalArgumentException("Bad address format");
        }
        address = addr;
    }

    /** 8-bit address. */
    public int getAddress() {
        return address;
    }

    /** The bus. */
    public I2CPort getPort() {
        return port;
    }
}
