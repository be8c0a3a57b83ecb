package brickless.device.sensor;

import brickless.hardware.SensorSocket.Wiring;
import java.util.Arrays;

/** NXT ultrasonic sensor on the I²C bus: distance in whole centimetres in its registers. */
final class NxtUltrasonicSensor extends SensorModel {
    /** Bus address, 8-bit form. */
    static final int ADDRESS = 0x02;
    private static final int DEVICE = 123;
    private static final int REGISTERS = 0x50;
    private static final int VERSION = 0x00;
    private static final int VENDOR = 0x08;
    private static final int PRODUCT = 0x10;
    private static final int INTERVAL = 0x40;
    private static final int COMMAND = 0x41;
    private static final int DISTANCES = 0x42;
    private static final int ECHOES = 8;
    private static final int OFF = 0;
    private static final int SINGLE = 1;
    private static final int CONTINUOUS = 2;
    private static final int NOTHING = 255;
    /** Time between pings, nanoseconds: assumption. */
    private static final long PING_NANOS = 50_000_000;
    /** Longest and shortest distance, centimetres. */
    private static final int FARTHEST_CM = 254;
    private static final int NEAREST_CM = 3;
    private static final double NOISE_CM = 0.4;

    private final SoundBeam beam = new SoundBeam();
    private final byte[] registers = new byte[REGISTERS];
    private long lastPing = Long.MIN_VALUE;

    NxtUltrasonicSensor(SensorSite site) {
        super(site);
        text(VERSION, "V1.0");
        text(VENDOR, "LEGO");
        text(PRODUCT, "Sonar");
        powerOff();
    }

    private void text(int register, String value) {
        for (int i = 0; i < value.length(); i++) {
            registers[register + i] = (byte) value.charAt(i);
        }
    }

    @Override Wiring wiring() {
        return Wiring.I2C;
    }

    @Override int deviceType() {
        return DEVICE;
    }

    @Override void powerOff() {
        registers[COMMAND] = CONTINUOUS;
        registers[INTERVAL] = 1;
        Arrays.fill(registers, DISTANCES, DISTANCES + ECHOES, (byte) NOTHING);
    }

    @Override void afterStep(long nowNanos) {
        long ping = nowNanos / PING_NANOS;
        if (registers[COMMAND] == CONTINUOUS && (ping != lastPing || site().ideal())) {
            ping(ping);
        }
    }

    private void ping(long number) {
        lastPing = number;
        double metres = beam.distance(site());
        long centimetres = metres > SoundBeam.REACH ? NOTHING
                : Math.round(metres * 100 + NOISE_CM * site().noise().bell(number, 0));
        registers[DISTANCES] = (byte) (centimetres > FARTHEST_CM ? NOTHING : Math.max(NEAREST_CM, centimetres));
    }

    /** A write: the first byte selects a register, the others are stored from there on. */
    void write(byte[] bytes, int offset, int length, long nowNanos) {
        for (int i = 1; i < length; i++) {
            int register = (bytes[offset] & 0xff) + i - 1;
            if (register >= INTERVAL && register < DISTANCES) {
                registers[register] = bytes[offset + i];
                commanded(register, nowNanos);
            }
        }
    }

    private void commanded(int register, long nowNanos) {
        if (register != COMMAND) {
            return;
        }
        if (registers[COMMAND] == SINGLE) {
            ping(nowNanos / PING_NANOS);
            registers[COMMAND] = OFF;
        } else if (registers[COMMAND] == CONTINUOUS) {
            ping(nowNanos / PING_NANOS);
        }
    }

    /** A read of registers from the one selected. */
    void read(int register, byte[] bytes, int offset, int length) {
        for (int i = 0; i < length; i++) {
            int from = register + i;
            bytes[offset + i] = from < REGISTERS ? registers[from] : 0;
        }
    }

    /** Distance in centimetres, 255 for nothing. */
    @Override double[] reading(long nowNanos) {
        return registers[COMMAND] == OFF ? new double[0] : new double[] {registers[DISTANCES] & 0xff};
    }
}
