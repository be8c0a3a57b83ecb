package lejos.internal.ev3;

import java.util.Arrays;
import lejos.hardware.DeviceException;
import lejos.hardware.port.UARTPort;

/** An input port opened for a serial sensor. The first change of mode connects to the sensor. */
public class EV3UARTPort extends EV3SensorIOPort implements UARTPort {
    private static final String RAW =
            "virtual sensors speak the EV3 sensor protocol only: raw serial lines are not available";

    private boolean connected;

    /** A port that is not open yet. */
    public EV3UARTPort() {}

    @Override
    public boolean initialiseSensor(int mode) {
        connected = mode >= 0 && socket().uart().initialise(mode);
        if (connected) {
            currentMode = mode;
        }
        return connected;
    }

    @Override
    public void resetSensor() {
        socket().uart().reset();
        connected = false;
    }

    @Override
    public boolean setMode(int mode) {
        if (mode == UART_RAW_MODE) {
            throw new UnsupportedOperationException(RAW);
        }
        if (!connected) {
            return initialiseSensor(mode);
        }
        if (mode < 0 || mode >= UART_MAX_MODES || getModeName(mode).equals("Unknown")) {
            return false;
        }
        if (!socket().uart().setMode(mode)) {
            return initialiseSensor(mode);
        }
        currentMode = mode;
        return true;
    }

    @Override
    public byte getByte() {
        byte[] message = new byte[1];
        receive(message, 0, 1);
        return message[0];
    }

    @Override
    public void getBytes(byte[] vals, int offset, int len) {
        receive(vals, offset, len);
    }

    @Override
    public int getShort() {
        short[] values = new short[1];
        getShorts(values, 0, 1);
        return values[0];
    }

    @Override
    public void getShorts(short[] vals, int offset, int len) {
        byte[] message = new byte[2 * len];
        receive(message, 0, message.length);
        for (int i = 0; i < len; i++) {
            vals[offset + i] = (short) (message[2 * i] & 0xff | message[2 * i + 1] << 8);
        }
    }

    /** Reads the newest message; a sensor that fell silent was unplugged and is connected anew. */
    private void receive(byte[] destination, int offset, int length) {
        int count = socket().uart().read(destination, offset, length);
        if (count == 0 && connected && length > 0) {
            if (!initialiseSensor(currentMode)) {
                throw new DeviceException("Sensor changed unable to reset", EV3Ports.mismatch(this));
            }
            count = socket().uart().read(destination, offset, length);
        }
        Arrays.fill(destination, offset + count, offset + length, (byte) 0);
    }

    @Override
    public String getModeName(int mode) {
        return mode < 0 ? "Unknown" : socket().uart().modeName(mode);
    }

    @Override
    public int write(byte[] buffer, int offset, int len) {
        return socket().uart().write(buffer, offset, len);
    }

    /** The first value of the newest message in the sensor's own unit; the port's name when no sensor is connected. */
    @Override
    public String toString() {
        if (port < 0 || !connected) {
            return getName();
        }
        byte[] message = new byte[2];
        receive(message, 0, message.length);
        return UartReading.format(getModeName(currentMode), message);
    }

    @Override
    public int rawRead(byte[] buffer, int offset, int len) {
        throw new UnsupportedOperationException(RAW);
    }

    @Override
    public int rawWrite(byte[] buffer, int offset, int len) {
        throw new UnsupportedOperationException(RAW);
    }

    @Override
    public void setBitRate(int bitRate) {
        throw new UnsupportedOperationException(RAW);
    }
}
