package brickless.concurrent;

import java.util.Collection;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.SortedSet;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.PriorityBlockingQueue} on virtual monitors. */
public class PriorityBlockingQueue<E> extends GuardedQueue<E> {
    private static final int DEFAULT_CAPACITY = 11;

    private final Comparator<? super E> comparator;

    /** Creates a queue in natural order. */
    public PriorityBlockingQueue() {
        this(DEFAULT_CAPACITY, null);
    }

    /** Creates a queue in natural order; IllegalArgumentException if the capacity is less than 1. */
    public PriorityBlockingQueue(int initialCapacity) {
        this(initialCapacity, null);
    }

    /** Creates a queue in that order (null: natural); IllegalArgumentException if the capacity is less than 1. */
    public PriorityBlockingQueue(int initialCapacity, Comparator<? super E> comparator) {
        super(new PriorityQueue<>(initialCapacity, comparator), Integer.MAX_VALUE);
        this.comparator = comparator;
    }

    /** Creates a queue that holds the elements, in their order if they come from a sorted set or a priority queue. */
    public PriorityBlockingQueue(Collection<? extends E> c) {
        this(DEFAULT_CAPACITY, PriorityBlockingQueue.<E>orderOf(c));
        addAll(c);
    }

    @SuppressWarnings("unchecked")
    private static <T> Comparator<? super T> orderOf(Collection<? extends T> c) {
        if (c instanceof SortedSet) {
            return (Comparator<? super T>) ((SortedSet<? extends T>) c).comparator();
        }
        if (c instanceof PriorityQueue) {
            return (Comparator<? super T>) ((PriorityQueue<? extends T>) c).comparator();
        }
        return c instanceof PriorityBlockingQueue
                ? (Comparator<? super T>) ((PriorityBlockingQueue<? extends T>) c).comparator() : null;
    }

    /** The order, or null for the natural one. */
    public Comparator<? super E> comparator() {
        return comparator;
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
