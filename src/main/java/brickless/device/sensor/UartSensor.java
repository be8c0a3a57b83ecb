package brickless.device.sensor;

import brickless.hardware.SensorSocket.Wiring;

/** A self-describing serial device with numbered modes. */
abstract class UartSensor extends SensorModel {
    /** Mode before the first selection and after a reset. */
    static final int DARK = -1;
    /** Bytes of the longest message of any device. */
    static final int LONGEST_MESSAGE = 8;

    private final int deviceType;
    private final UartMode[] modes;
    private int mode = DARK;

    UartSensor(SensorSite site, int deviceType, UartMode... modes) {
        super(site);
        this.deviceType = deviceType;
        this.modes = modes;
    }

    @Override
    final Wiring wiring() {
        return Wiring.UART;
    }

    @Override
    final int deviceType() {
        return deviceType;
    }

    /** Present mode, {@link #DARK} before the first. */
    final int mode() {
        return mode;
    }

    final boolean has(int number) {
        return number >= 0 && number < modes.length;
    }

    final UartMode mode(int number) {
        return modes[number];
    }

    /** Selects an existing mode. */
    final void select(int number, long nowNanos) {
        mode = number;
        selected(nowNanos);
    }

    @Override
    final void powerOff() {
        mode = DARK;
        selected(0);
    }

    /** The mode has changed. */
    void selected(long nowNanos) {
        // Few devices do more than answer differently.
    }

    /** Writes the message of the present mode, {@code mode(mode()).bytes()} long. */
    abstract void message(long nowNanos, byte[] out);

    @Override
    final double[] reading(long nowNanos) {
        if (mode == DARK) {
            return new double[0];
        }
        byte[] message = new byte[LONGEST_MESSAGE];
        message(nowNanos, message);
        double[] values = new double[modes[mode].values()];
        for (int i = 0; i < values.length; i++) {
            values[i] = modes[mode].value(message, i);
        }
        return values;
    }

    @Override
    final String modeName() {
        return mode == DARK ? "" : modes[mode].name();
    }

    static void putShort(byte[] out, int index, int value) {
        out[2 * index] = (byte) value;
        out[2 * index + 1] = (byte) (value >> 8);
    }
}
