package brickless.kernel;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * What a kernel is told before a run; start from {@link #defaults()}.
 *
 * @param name the robot's name, for host thread names and dumps
 * @param seed of the program's random stream
 * @param scheduleSeed of a random schedule; empty for round-robin
 * @param stepNanos length of the physics step, positive
 * @param limitNanos virtual time at which the run is ended, positive; {@code Long.MAX_VALUE} for no limit
 * @param epochMillis what {@code System.currentTimeMillis} says at virtual time 0
 * @param backend where stacks live
 * @param watchdogNanos host time without a kernel entry after which a program is a runaway; 0 for no watchdog
 * @param maximumThreads live program threads at which {@code Thread.start} throws OutOfMemoryError
 * @param stackBytes host stack for each program thread
 */
public record KernelSettings(
        String name,
        long seed,
        OptionalLong scheduleSeed,
        long stepNanos,
        long limitNanos,
        long epochMillis,
        BackendChoice backend,
        long watchdogNanos,
        int maximumThreads,
        long stackBytes) {
    /** 2 ms. */
    private static final long DEFAULT_STEP_NANOS = 2_000_000L;
    /** 1 January 2015, 00:00 UTC: an arbitrary day in leJOS 0.9.1's year. */
    private static final long DEFAULT_EPOCH_MILLIS = 1_420_070_400_000L;
    /** 10 s. */
    private static final long DEFAULT_WATCHDOG_NANOS = 10_000_000_000L;
    /** Assumption: about what fits in the brick's 64 MB. */
    private static final int DEFAULT_MAXIMUM_THREADS = 500;
    private static final long DEFAULT_STACK_BYTES = 16L << 20;

    /** Checks the ranges. */
    public KernelSettings {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(scheduleSeed, "scheduleSeed");
        Objects.requireNonNull(backend, "backend");
        if (stepNanos <= 0 || limitNanos <= 0 || watchdogNanos < 0 || maximumThreads < 1 || stackBytes < 0) {
            throw new IllegalArgumentException("out of range: step " + stepNanos + " ns, limit " + limitNanos
                    + " ns, watchdog " + watchdogNanos + " ns, threads " + maximumThreads + ", stack " + stackBytes
                    + " bytes");
        }
    }

    /** Seed 0, round-robin, 2 ms steps, no limit, the best back-end, a watchdog of 10 s. */
    public static KernelSettings defaults() {
        return new KernelSettings("robot", 0, OptionalLong.empty(), DEFAULT_STEP_NANOS, Long.MAX_VALUE,
                DEFAULT_EPOCH_MILLIS, BackendChoice.AUTO, DEFAULT_WATCHDOG_NANOS, DEFAULT_MAXIMUM_THREADS,
                DEFAULT_STACK_BYTES);
    }

    /** With another name. */
    public KernelSettings withName(String value) {
        return new KernelSettings(value, seed, scheduleSeed, stepNanos, limitNanos, epochMillis, backend, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With another seed of the program's random stream. */
    public KernelSettings withSeed(long value) {
        return new KernelSettings(name, value, scheduleSeed, stepNanos, limitNanos, epochMillis, backend, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With a random schedule. */
    public KernelSettings withScheduleSeed(long value) {
        return new KernelSettings(name, seed, OptionalLong.of(value), stepNanos, limitNanos, epochMillis, backend,
                watchdogNanos, maximumThreads, stackBytes);
    }

    /** With another step length in nanoseconds. */
    public KernelSettings withStepNanos(long value) {
        return new KernelSettings(name, seed, scheduleSeed, value, limitNanos, epochMillis, backend, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With a limit of virtual time in nanoseconds. */
    public KernelSettings withLimitNanos(long value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, value, epochMillis, backend, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With another date at virtual time 0, in milliseconds since 1970. */
    public KernelSettings withEpochMillis(long value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, limitNanos, value, backend, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With another back-end. */
    public KernelSettings withBackend(BackendChoice value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, limitNanos, epochMillis, value, watchdogNanos,
                maximumThreads, stackBytes);
    }

    /** With another patience of the host watchdog in nanoseconds of host time, 0 for none. */
    public KernelSettings withWatchdogNanos(long value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, limitNanos, epochMillis, backend, value,
                maximumThreads, stackBytes);
    }

    /** With another limit of live program threads. */
    public KernelSettings withMaximumThreads(int value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, limitNanos, epochMillis, backend, watchdogNanos,
                value, stackBytes);
    }

    /** With another host stack size in bytes. */
    public KernelSettings withStackBytes(long value) {
        return new KernelSettings(name, seed, scheduleSeed, stepNanos, limitNanos, epochMillis, backend, watchdogNanos,
                maximumThreads, value);
    }
}
