package brickless.concurrent;

import java.util.ArrayDeque;
import java.util.Collection;

/** {@code java.util.concurrent.LinkedBlockingQueue} on virtual monitors. */
public class LinkedBlockingQueue<E> extends GuardedQueue<E> {
    /** Creates a queue without a limit. */
    public LinkedBlockingQueue() {
        this(Integer.MAX_VALUE);
    }

    /** Creates a queue; IllegalArgumentException if the capacity is less than 1. */
    public LinkedBlockingQueue(int capacity) {
        super(new ArrayDeque<>(), ArrayBlockingQueue.requirePositive(capacity));
    }

    /** Creates a queue without a limit that holds the elements. */
    public LinkedBlockingQueue(Collection<? extends E> c) {
        this();
        addAll(c);
    }
}
