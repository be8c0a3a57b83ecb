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

    // The rest is the same as in the superclass, with the bound of E in the descriptors that programs link to.

    @Override
    public boolean add(E e) {
        return super.add(e);
    }

    @Override
    public boolean offer(E e) {
        return super.offer(e);
    }

    @Override
    public E poll() {
        return super.poll();
    }

    @Override
    public E poll(long timeout, TimeUnit unit) throws InterruptedException {
        return super.poll(timeout, unit);
    }

    @Override
    public E take() throws InterruptedException {
        return super.take();
    }

    @Override
    public E peek() {
        return super.peek();
    }

    @Override
    public E remove() {
        return super.remove();
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

    /** There is no limit. */
    @Override
    public int remainingCapacity() {
        return Integer.MAX_VALUE;
    }
}
