package brickless.concurrent.util;

import java.util.Comparator;
import java.util.SortedSet;

/** A sorted set behind one monitor. */
class SynchronizedSortedSet<E> extends SynchronizedSet<E> implements SortedSet<E> {
    private final SortedSet<E> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedSortedSet(SortedSet<E> target, Object mutex) {
        super(target, mutex);
        this.target = target;
    }

    @Override
    public Comparator<? super E> comparator() {
        synchronized (mutex) {
            return target.comparator();
        }
    }

    @Override
    public E first() {
        synchronized (mutex) {
            return target.first();
        }
    }

    @Override
    public E last() {
        synchronized (mutex) {
            return target.last();
        }
    }

    @Override
    public SortedSet<E> subSet(E fromElement, E toElement) {
        synchronized (mutex) {
            return new SynchronizedSortedSet<>(target.subSet(fromElement, toElement), mutex);
        }
    }

    @Override
    public SortedSet<E> headSet(E toElement) {
        synchronized (mutex) {
            return new SynchronizedSortedSet<>(target.headSet(toElement), mutex);
        }
    }

    @Override
    public SortedSet<E> tailSet(E fromElement) {
        synchronized (mutex) {
            return new SynchronizedSortedSet<>(target.tailSet(fromElement), mutex);
        }
    }
}
