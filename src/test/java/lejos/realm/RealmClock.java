package lejos.realm;

import brickless.device.panel.PanelBench;
import brickless.hardware.BrickAccess;
import brickless.kernel.Processor;

/** Stands in for the clocks and {@code Thread.sleep} of rewritten classes. Program start is at 1,000,000 s. */
public final class RealmClock {
    private static final long NANOS_PER_MILLI = 1_000_000;
    private static final long START_MILLIS = 1_000_000_000;
    private static final long READ_NANOS = 2_000;

    private RealmClock() {}

    public static void sleep(long millis) throws InterruptedException {
        sleep(millis, 0);
    }

    public static void sleep(long millis, int nanos) throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        processor().charge(millis * NANOS_PER_MILLI + nanos);
    }

    public static long nanoTime() {
        processor().charge(READ_NANOS);
        return processor().nowNanos();
    }

    public static long currentTimeMillis() {
        return START_MILLIS + nanoTime() / NANOS_PER_MILLI;
    }

    private static Processor processor() {
        return ((PanelBench) BrickAccess.brick()).processor();
    }
}
