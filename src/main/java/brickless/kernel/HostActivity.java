package brickless.kernel;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.concurrent.locks.LockSupport;

/**
 * What a host thread is doing.
 *
 * @param busyNanos processor time it has used, 0 where the host cannot tell
 * @param waiting whether it waits for something other than its turn or a processor
 */
record HostActivity(long busyNanos, boolean waiting) {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    /** Looks at a thread; null looks like one that waits for a processor. */
    static HostActivity of(Thread thread) {
        if (thread == null) {
            return new HostActivity(0, false);
        }
        long busyNanos = THREADS.isThreadCpuTimeSupported() ? Math.max(0, THREADS.getThreadCpuTime(thread.getId())) : 0;
        boolean running = switch (thread.getState()) {
            case BLOCKED, WAITING, TIMED_WAITING -> LockSupport.getBlocker(thread) instanceof Turn;
            default -> true;
        };
        return new HostActivity(busyNanos, !running);
    }
}
