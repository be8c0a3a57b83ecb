package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** {@code java.util.concurrent.Exchanger} on virtual monitors. */
public class Exchanger<V> {
    private final Object monitor = new Object();
    /** The offer of the thread that waits for a partner, or null; guarded by the monitor. */
    private Offer<V> open;

    private static final class Offer<V> {
        final V given;
        V received;
        boolean accepted;

        Offer(V given) {
            this.given = given;
        }
    }

    /** Creates an exchanger. */
    public Exchanger() {
    }

    /** Waits for a partner and swaps. */
    public V exchange(V x) throws InterruptedException {
        try {
            return exchange(x, Deadline.NEVER);
        } catch (TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    /** Waits at most that long for a partner and swaps. */
    public V exchange(V x, long timeout, TimeUnit unit) throws InterruptedException, TimeoutException {
        return exchange(x, Deadline.after(timeout, unit));
    }

    private V exchange(V x, Deadline deadline) throws InterruptedException, TimeoutException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        synchronized (monitor) {
            if (open == null) {
                return awaitPartner(x, deadline);
            }
            Offer<V> partner = open;
            open = null;
            partner.received = x;
            partner.accepted = true;
            monitor.notifyAll();
            return partner.given;
        }
    }

    private V awaitPartner(V x, Deadline deadline) throws InterruptedException, TimeoutException {
        Offer<V> mine = new Offer<>(x);
        open = mine;
        try {
            while (!mine.accepted) {
                if (!deadline.await(monitor)) {
                    throw new TimeoutException();
                }
            }
        } catch (InterruptedException e) {
            if (!mine.accepted) {
                throw e;
            }
            Thread.currentThread().interrupt();
        } finally {
            if (open == mine) {
                open = null;
            }
        }
        return mine.received;
    }
}
