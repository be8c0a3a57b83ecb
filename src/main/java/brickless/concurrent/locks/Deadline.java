package brickless.concurrent.locks;

import java.util.concurrent.TimeUnit;

/** A moment on the program's own clock until which a thread is willing to wait. Immutable. */
public final class Deadline {
    /** A deadline that never passes. */
    public static final Deadline NEVER = new Deadline(true, 0);

    private static final long NANOS_PER_MILLI = 1_000_000L;

    private final boolean never;
    private final long atNanos;

    private Deadline(boolean never, long atNanos) {
        this.never = never;
        this.atNanos = atNanos;
    }

    /**
     * A deadline {@code nanos} from now; one that is not positive has passed already, one beyond 146 years never
     * passes.
     */
    public static Deadline after(long nanos) {
        return nanos > Long.MAX_VALUE / 2 ? NEVER : new Deadline(false, System.nanoTime() + Math.max(nanos, 0));
    }

    /** A deadline {@code time} of {@code unit} from now. */
    public static Deadline after(long time, TimeUnit unit) {
        return after(unit.toNanos(time));
    }

    /**
     * Nanoseconds that are left; zero or less when the deadline has passed, {@code Long.MAX_VALUE} when it never does.
     */
    public long nanosLeft() {
        return never ? Long.MAX_VALUE : atNanos - System.nanoTime();
    }

    /** Whether there is no time left. */
    public boolean passed() {
        return nanosLeft() <= 0;
    }

    /** The earlier of this deadline and one {@code nanos} from now. */
    public Deadline orAfter(long nanos) {
        return nanos < nanosLeft() ? after(nanos) : this;
    }

    /**
     * Waits once on a monitor that the caller holds; like {@code Object.wait} it may return early.
     *
     * @return false, without having waited, when the deadline has passed
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public boolean await(Object monitor) throws InterruptedException {
        if (never) {
            monitor.wait();
            return true;
        }
        long left = nanosLeft();
        if (left <= 0) {
            return false;
        }
        monitor.wait(left / NANOS_PER_MILLI, (int) (left % NANOS_PER_MILLI));
        return true;
    }
}
