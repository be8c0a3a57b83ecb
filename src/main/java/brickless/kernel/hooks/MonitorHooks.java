package brickless.kernel.hooks;

/** {@code synchronized}, {@code wait} and {@code notify} of rewritten code. Per robot. */
public final class MonitorHooks {
    private static final long NANOS_PER_MILLI = 1_000_000L;

    private MonitorHooks() {}

    /** {@code monitorenter}; blocks. */
    public static void enter(Object lock) {
        Hooks.machine().monitorEnter(lock);
    }

    /** {@code monitorexit}; never switches fibres. */
    public static void exit(Object lock) {
        Hooks.machine().monitorExit(lock);
    }

    /** {@code lock.wait()}. */
    public static void wait(Object lock) throws InterruptedException {
        Hooks.machine().monitorWait(nonNull(lock), 0);
    }

    /** {@code lock.wait(millis)}. */
    public static void wait(Object lock, long millis) throws InterruptedException {
        Hooks.machine().monitorWait(nonNull(lock), nanos(millis, 0));
    }

    /** {@code lock.wait(millis, nanos)}. */
    public static void wait(Object lock, long millis, int nanos) throws InterruptedException {
        Hooks.machine().monitorWait(nonNull(lock), nanos(millis, nanos));
    }

    /** {@code lock.notify()}. */
    public static void notify(Object lock) {
        Hooks.machine().monitorNotify(nonNull(lock), false);
    }

    /** {@code lock.notifyAll()}. */
    public static void notifyAll(Object lock) {
        Hooks.machine().monitorNotify(nonNull(lock), true);
    }

    /** {@code Thread.holdsLock(lock)}. */
    public static boolean holdsLock(Object lock) {
        return Hooks.machine().holdsMonitor(nonNull(lock));
    }

    /**
     * Milliseconds and nanoseconds as the JDK's timed waits take them, in nanoseconds; the largest long if that is
     * more.
     */
    static long nanos(long millis, int nanos) {
        if (millis < 0) {
            throw new IllegalArgumentException("timeout value is negative");
        }
        if (nanos < 0 || nanos >= NANOS_PER_MILLI) {
            throw new IllegalArgumentException("nanosecond timeout value out of range");
        }
        return millis > (Long.MAX_VALUE - nanos) / NANOS_PER_MILLI ? Long.MAX_VALUE : millis * NANOS_PER_MILLI + nanos;
    }

    private static Object nonNull(Object lock) {
        if (lock == null) {
            throw new NullPointerException();
        }
        return lock;
    }
}
