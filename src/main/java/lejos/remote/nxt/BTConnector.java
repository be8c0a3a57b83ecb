package lejos.remote.nxt;

/** Makes Bluetooth connections. No other brick is in range of a virtual one, so nobody answers and nobody calls. */
public class BTConnector extends NXTCommConnector {
    private static final long NANOS_PER_MILLI = 1_000_000;

    private boolean waiting;

    /** A connector. */
    public BTConnector() {}

    @Override
    public BTConnection connect(String target, int mode) {
        return null;
    }

    @Override
    public synchronized BTConnection waitForConnection(int timeout, int mode) {
        long end = System.nanoTime() + timeout * NANOS_PER_MILLI;
        waiting = true;
        try {
            while (waiting) {
                long left = timeout == 0 ? 0 : Math.max(1, (end - System.nanoTime()) / NANOS_PER_MILLI);
                wait(left);
                waiting &= timeout == 0 || System.nanoTime() < end;
            }
        } catch (InterruptedException e) {
            waiting = false;
            Thread.currentThread().interrupt();
        }
        return null;
    }

    @Override
    public synchronized boolean cancel() {
        boolean cancelled = waiting;
        waiting = false;
        notifyAll();
        return cancelled;
    }
}
