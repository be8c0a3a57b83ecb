package brickless.concurrent.util;

import java.util.Iterator;
import java.util.NavigableSet;

/** A navigable set behind one monitor. */
final class SynchronizedNavigableSet<E> extends SynchronizedSortedSet<E> implements NavigableSet<E> {
    private final NavigableSet<E> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedNavigableSet(NavigableSet<E> target, Object mutex) {
        super(target, mutex);
        this.target = target;
    }

    private NavigableSet<E> guard(NavigableSet<E> view) {
        return new SynchronizedNavigableSet<>(view, mutex);
    }

    @Override
    public E lower(E e) {
        synchronized (mutex) {
            return target.lower(e);
        }
    }

    @Override
    public E floor(E e) {
        synchronized (mutex) {
            return target.floor(e);
        }
    }

    @Override
    public E ceiling(E e) {
        synchronized (mutex) {
            return target.ceiling(e);
        }
    }

    @Override
    public E higher(E e) {
        synchronized (mutex) {
            return target.higher(e);
        }
    }

    @Override
    public E pollFirst() {
        synchronized (mutex) {
            return target.pollFirst();
        }
    }

    @Override
    public E pollLast() {
        synchronized (mutex) {
            return target.pollLast();
        }
    }

    @Override
    public NavigableSet<E> descendingSet() {
        synchronized (mutex) {
            return guard(target.descendingSet());
        }
    }

    @Override
    public Iterator<E> descendingIterator() {
        return descendingSet().iterator();
    }

    @Override
    public NavigableSet<E> subSet(E fromElement, E toElement) {
        return subSet(fromElement, true, toElement, false);
    }

    @Override
    public NavigableSet<E> headSet(E toElement) {
        return headSet(toElement, false);
    }

    @Override
    public NavigableSet<E> tailSet(E fromElement) {
        return tailSet(fromElement, true);
    }

    @Override
    public NavigableSet<E> subSet(E fromElement, boolean fromInclusive, E toElement, boolean toInclusive) {
        synchronized (mutex) {
            return guard(target.subSet(fromElement, fromInclusive, toElement, toInclusive));
        }
    }

    @Override
    public NavigableSet<E> headSet(E toElement, boolean inclusive) {
        synchronized (mutex) {
            return guard(target.headSet(toElement, inclusive));
        }
    }

    @Override
    public NavigableSet<E> tailSet(E fromElement, boolean inclusive) {
        synchronized (mutex) {
            return guard(target.tailSet(fromElement, inclusive));
        }
    }
}
