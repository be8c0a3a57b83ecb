package brickless.concurrent;

import java.util.ArrayDeque;
import java.util.Collection;

/** {@code java.util.concurrent.ArrayBlockingQueue} on virtual monitors. */
public class ArrayBlockingQueue<E> extends GuardedQueue<E> {
    /** Creates a queue; IllegalArgumentException if the capacity is less than 1. */
    public ArrayBlockingQueue(int capacity) {
        super(new ArrayDeque<>(), requirePositive(capacity));
    }

    /** Creates a queue; fairness is accepted, blocked threads are always woken in order of arrival. */
    public ArrayBlockingQueue(int capacity, boolean fair) {
        this(capacity);
    }

    /** Creates a queue with elements; IllegalArgumentException if they exceed the capacity. */
    public ArrayBlockingQueue(int capacity, boolean fair, Collection<? extends E> c) {
        this(capacity);
        for (E element : c) {
            if (!offer(element)) {
                throw new IllegalArgumentException("more elements than capacity");
            }
        }
    }

    static int requirePositive(int capacity) {
        if (capacity <= 0) {
            throw new IllegalArgumentException("capacity <= 0");
        }
        return capacity;
    }
}
