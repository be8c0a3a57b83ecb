package brickless.concurrent;

import java.util.Collection;
import java.util.PriorityQueue;
import java.util.concurrent.Delayed;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.DelayQueue} on virtual monitors. */
public class DelayQueue<E extends Delayed> extends GuardedQueue<E> {
    /** Creates an empty queue. */
    public DelayQueue() {
        super(new PriorityQueue<>(), Integer.MAX_VALUE);
    }

    /** Creates a queue that holds the elements. */
    public DelayQueue(Collection<? extends E> c) {
        this();
        addAll(c);
    }

    @Override
    long nanosUntilReady(E head) {
        return head.getDelay(TimeUnit.NANOSECONDS);
    }

    /** Never blocks. */
    @Override
    public void put(E e) {
        offer(e);
    }

    /** Never blocks. */
    @Override
    public boolean offer(E e, long timeout, TimeUnit unit) {
        return offer(e);
    }
}
