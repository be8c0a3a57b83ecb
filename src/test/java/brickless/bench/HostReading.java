package brickless.bench;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * What the host's clocks and counters say at one moment.
 *
 * @param wallNanos wall clock
 * @param processNanos processor time of the whole JVM, its compiler and garbage collector included
 * @param threadNanos processor time of all threads that live now, without compiler and collector
 * @param allocatedBytes what all threads that live now have allocated
 */
record HostReading(long wallNanos, long processNanos, long threadNanos, long allocatedBytes) {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    static HostReading now() {
        long[] threads = THREADS.getAllThreadIds();
        long bytes = Arrays.stream(THREADS.getThreadAllocatedBytes(threads)).filter(b -> b > 0).sum();
        long nanos = Arrays.stream(THREADS.getThreadCpuTime(threads)).filter(n -> n > 0).sum();
        return new HostReading(System.nanoTime(), SYSTEM.getProcessCpuTime(), nanos, bytes);
    }

    /** Processor time of the calling thread alone. */
    static long ownNanos() {
        return THREADS.getCurrentThreadCpuTime();
    }

    /** What the calling thread has allocated. */
    static long ownBytes() {
        return THREADS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    double wallSecondsSince(HostReading earlier) {
        return (wallNanos - earlier.wallNanos) / 1e9;
    }

    double processSecondsSince(HostReading earlier) {
        return (processNanos - earlier.processNanos) / 1e9;
    }

    double threadSecondsSince(HostReading earlier) {
        return (threadNanos - earlier.threadNanos) / 1e9;
    }
}
