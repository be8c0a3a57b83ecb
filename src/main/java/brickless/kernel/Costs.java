package brickless.kernel;

import brickless.kernel.hooks.InstructionCharges;

/**
 * What operations cost in virtual time, in nanoseconds.
 *
 * <p>All of them are estimates for the EV3's 300 MHz ARM9 running leJOS 0.9.1: assumptions, not measurements of a
 * brick. They need only be right in order of magnitude: they decide how often a polling loop polls and that no loop
 * is free.
 */
public final class Costs {
    /** One turn of a loop that does some work (estimate). */
    public static final int BACK_EDGE_NANOS = InstructionCharges.BACK_EDGE_NANOS;
    /** One turn of a loop that only reads and compares, which stands for many turns (estimate). */
    public static final int PURE_SPIN_NANOS = InstructionCharges.PURE_SPIN_NANOS;
    /** The first {@code Thread.yield} after progress (estimate). */
    public static final int YIELD_NANOS = 100_000;
    /**
     * The longest charge for {@code Thread.yield}, reached by doubling while a thread yields without progress
     * (estimate).
     */
    public static final int LONGEST_YIELD_NANOS = 1_000_000;
    /** Reading an analog or UART sensor (estimate). */
    public static final int SENSOR_READ_NANOS = 200_000;
    /** One I²C transaction; the calling thread blocks for it (estimate). */
    public static final int I2C_TRANSACTION_NANOS = 5_000_000;
    /** {@code isMoving}, {@code getTachoCount} and other reads of a motor (estimate). */
    public static final int MOTOR_READ_NANOS = 20_000;
    /** A command to a motor (estimate). */
    public static final int MOTOR_COMMAND_NANOS = 300_000;
    /** A line of text on the display or the console (estimate). */
    public static final int TEXT_LINE_NANOS = 500_000;
    /** {@code System.currentTimeMillis} and {@code System.nanoTime} (estimate). */
    public static final int CLOCK_READ_NANOS = 2_000;
    /** Entering a free monitor (estimate). */
    public static final int MONITOR_ENTER_NANOS = 500;
    /** {@code Thread.start} (estimate). */
    public static final int THREAD_START_NANOS = 500_000;
    /** Allocating an array, for each byte (estimate). */
    public static final int ALLOCATED_BYTE_NANOS = InstructionCharges.ALLOCATION_NANOS_PER_BYTE;

    private Costs() {
    }
}
