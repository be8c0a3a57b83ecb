package brickless.hardware.fake;

import brickless.hardware.AnalogChannel;
import brickless.hardware.I2cChannel;
import brickless.hardware.SensorSocket;
import brickless.hardware.UartChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/** An input port whose device says what the test tells it to say. Empty until something is plugged in. */
public final class FakeSensor implements SensorSocket {
    private static final int EMPTY = 126;

    private final List<String> log = new ArrayList<>();
    private final FakeAnalog analog = new FakeAnalog(log);
    private final FakeUart uart = new FakeUart(log);
    private final FakeI2c i2c = new FakeI2c(log);
    private Wiring wiring = Wiring.NONE;
    private int deviceType = EMPTY;
    private String name = "none";

    /** Plugs a device in. */
    public FakeSensor plug(Wiring newWiring, int newDeviceType, String newName) {
        wiring = newWiring;
        deviceType = newDeviceType;
        name = newName;
        uart.plugged = newWiring == Wiring.UART;
        i2c.plugged = newWiring == Wiring.I2C;
        return this;
    }

    /** Plugs a serial sensor in whose modes 0, 1, 2 … have these names. */
    public FakeSensor plugUart(int newDeviceType, String newName, String... modes) {
        uart.modes = List.of(modes);
        return plug(Wiring.UART, newDeviceType, newName);
    }

    /** Plugs the device out. */
    public void unplug() {
        plug(Wiring.NONE, EMPTY, "none");
    }

    /**
     * Everything that was done to the port, in order, e.g. {@code "initialise 0"}, {@code "type 5"}, {@code "write 41
     * 02"}.
     */
    public List<String> log() {
        return log;
    }

    @Override
    public Wiring wiring() {
        return wiring;
    }

    @Override
    public int deviceType() {
        return deviceType;
    }

    @Override
    public String connected() {
        return name;
    }

    @Override
    public void expect(String lejosClass) {
        log.add("expect " + lejosClass);
    }

    @Override
    public FakeAnalog analog() {
        return analog;
    }

    @Override
    public FakeUart uart() {
        return uart;
    }

    @Override
    public FakeI2c i2c() {
        return i2c;
    }

    @Override
    public void release() {
        log.add("release");
    }

    /** Analogue pins with settable converter values. */
    public static final class FakeAnalog implements AnalogChannel {
        private final List<String> log;
        private volatile int pin1;
        private volatile int pin6;
        private float[] colours = {};

        FakeAnalog(List<String> log) {
            this.log = log;
        }

        /** Sets the converter's values, 0 to 4095. */
        public void raw(int newPin1, int newPin6) {
            pin1 = newPin1;
            pin6 = newPin6;
        }

        /** Sets what a colour sensor answers. */
        public void colours(float... volts) {
            colours = volts;
        }

        @Override
        public double pin1Volts() {
            return pin1 * 5.0 / 4095;
        }

        @Override
        public double pin6Volts() {
            return pin6 * 5.0 / 4095;
        }

        @Override
        public boolean setType(int type) {
            log.add("type " + type);
            return true;
        }

        @Override
        public float[] colourVolts() {
            return colours;
        }
    }

    /** A serial line with settable messages. */
    public static final class FakeUart implements UartChannel {
        private final List<String> log;
        private final TreeMap<Integer, byte[]> messages = new TreeMap<>();
        private List<String> modes = List.of();
        private boolean plugged;
        private int mode = -1;

        FakeUart(List<String> log) {
            this.log = log;
        }

        /** Sets the message of a mode; each value is one byte. */
        public void bytes(int ofMode, int... values) {
            byte[] message = new byte[values.length];
            for (int i = 0; i < values.length; i++) {
                message[i] = (byte) values[i];
            }
            messages.put(ofMode, message);
        }

        /** Sets the message of a mode; each value is two bytes, the low one first. */
        public void shorts(int ofMode, int... values) {
            byte[] message = new byte[2 * values.length];
            for (int i = 0; i < values.length; i++) {
                message[2 * i] = (byte) values[i];
                message[2 * i + 1] = (byte) (values[i] >> 8);
            }
            messages.put(ofMode, message);
        }

        @Override
        public boolean initialise(int newMode) {
            log.add("initialise " + newMode);
            return select(newMode);
        }

        @Override
        public boolean setMode(int newMode) {
            log.add("mode " + newMode);
            return select(newMode);
        }

        private boolean select(int newMode) {
            boolean known = plugged && newMode >= 0 && newMode < modes.size();
            if (known) {
                mode = newMode;
            }
            return known;
        }

        @Override
        public void reset() {
            log.add("reset");
            mode = -1;
        }

        @Override
        public int read(byte[] destination, int offset, int length) {
            if (!plugged || mode < 0) {
                return 0;
            }
            byte[] message = messages.getOrDefault(mode, new byte[32]);
            int count = Math.min(length, message.length);
            System.arraycopy(message, 0, destination, offset, count);
            return count;
        }

        @Override
        public int write(byte[] source, int offset, int length) {
            log.add("write " + hex(source, offset, length));
            return length;
        }

        @Override
        public String modeName(int ofMode) {
            return plugged && ofMode < modes.size() ? modes.get(ofMode) : "Unknown";
        }
    }

    /** A bus with one device at address 2 and 256 registers. */
    public static final class FakeI2c implements I2cChannel {
        private final List<String> log;
        private final List<Status> troubles = new ArrayList<>();
        private final byte[] registers = new byte[256];
        private boolean plugged;

        FakeI2c(List<String> log) {
            this.log = log;
        }

        /** Sets registers from {@code first} on. */
        public void registers(int first, int... values) {
            for (int i = 0; i < values.length; i++) {
                registers[first + i] = (byte) values[i];
            }
        }

        /** Sets registers from {@code first} on to the characters of a text. */
        public void text(int first, String text) {
            registers(first, text.chars().toArray());
        }

        /** The outcomes of the next transactions. */
        public void troubles(Status... next) {
            troubles.addAll(List.of(next));
        }

        @Override
        public void configure(boolean fast, boolean nineVolts) {
            log.add("configure " + (fast ? "100kHz" : "10kHz") + (nineVolts ? " 9V" : ""));
        }

        @Override
        public Status transaction(int address, byte[] write, int writeOffset, int writeLength, byte[] read,
                int readOffset, int readLength) {
            log.add((readLength > 0 ? "read " : "write ") + hex(write, writeOffset, writeLength));
            Status trouble = troubles.isEmpty() ? Status.OK : troubles.remove(0);
            if (trouble != Status.OK || !plugged || address != 2) {
                return trouble != Status.OK ? trouble : Status.NO_ANSWER;
            }
            int register = write[writeOffset] & 0xff;
            System.arraycopy(write, writeOffset + 1, registers, register, writeLength - 1);
            if (readLength > 0) {
                System.arraycopy(registers, register, read, readOffset, readLength);
            }
            return Status.OK;
        }
    }

    private static String hex(byte[] bytes, int offset, int length) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < length; i++) {
            text.append(i == 0 ? "" : " ").append(String.format("%02x", bytes[offset + i]));
        }
        return text.toString();
    }
}
