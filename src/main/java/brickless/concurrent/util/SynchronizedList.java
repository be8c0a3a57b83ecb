package brickless.concurrent.util;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.ListIterator;
import java.util.RandomAccess;
import java.util.function.UnaryOperator;

/** A list behind one monitor. */
class SynchronizedList<E> extends SynchronizedCollection<E> implements List<E> {
    private final List<E> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedList(List<E> target, Object mutex) {
        super(target, mutex);
        this.target = target;
    }

    /** Keeps the promise of fast random access. */
    static final class OfRandomAccess<E> extends SynchronizedList<E> implements RandomAccess {
        OfRandomAccess(List<E> target, Object mutex) {
            super(target, mutex);
        }
    }

    static <T> SynchronizedList<T> of(List<T> target, Object mutex) {
        return target instanceof RandomAccess ? new OfRandomAccess<>(target, mutex)
                : new SynchronizedList<>(target, mutex);
    }

    @Override
    public E get(int index) {
        synchronized (mutex) {
            return target.get(index);
        }
    }

    @Override
    public E set(int index, E element) {
        synchronized (mutex) {
            return target.set(index, element);
        }
    }

    @Override
    public void add(int index, E element) {
        synchronized (mutex) {
            target.add(index, element);
        }
    }

    @Override
    public E remove(int index) {
        synchronized (mutex) {
            return target.remove(index);
        }
    }

    @Override
    public int indexOf(Object o) {
        synchronized (mutex) {
            return target.indexOf(o);
        }
    }

    @Override
    public int lastIndexOf(Object o) {
        synchronized (mutex) {
            return target.lastIndexOf(o);
        }
    }

    @Override
    public boolean addAll(int index, Collection<? extends E> c) {
        synchronized (mutex) {
            return target.addAll(index, c);
        }
    }

    @Override
    public void replaceAll(UnaryOperator<E> operator) {
        synchronized (mutex) {
            target.replaceAll(operator);
        }
    }

    @Override
    public void sort(Comparator<? super E> c) {
        synchronized (mutex) {
            target.sort(c);
        }
    }

    @Override
    public List<E> subList(int fromIndex, int toIndex) {
        synchronized (mutex) {
            return of(target.subList(fromIndex, toIndex), mutex);
        }
    }

    @Override
    public ListIterator<E> listIterator() {
        return target.listIterator();
    }

    @Override
    public ListIterator<E> listIterator(int index) {
        return target.listIterator(index);
    }

    @Override
    public boolean equals(Object o) {
        synchronized (mutex) {
            return o == this || target.equals(o);
        }
    }

    @Override
    public int hashCode() {
        synchronized (mutex) {
            return target.hashCode();
        }
    }
}
