package brickless.concurrent.util;

import java.util.Collection;
import java.util.Iterator;
import java.util.Objects;
import java.util.Spliterator;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** A collection behind one monitor; iterators and streams are for the caller to guard. */
class SynchronizedCollection<E> implements Collection<E> {
    /** What every method locks. */
    final Object mutex;
    private final Collection<E> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedCollection(Collection<E> target, Object mutex) {
        this.target = Objects.requireNonNull(target);
        this.mutex = mutex == null ? this : mutex;
    }

    @Override
    public int size() {
        synchronized (mutex) {
            return target.size();
        }
    }

    @Override
    public boolean isEmpty() {
        synchronized (mutex) {
            return target.isEmpty();
        }
    }

    @Override
    public boolean contains(Object o) {
        synchronized (mutex) {
            return target.contains(o);
        }
    }

    @Override
    public Object[] toArray() {
        synchronized (mutex) {
            return target.toArray();
        }
    }

    @Override
    public <T> T[] toArray(T[] array) {
        synchronized (mutex) {
            return target.toArray(array);
        }
    }

    @Override
    public <T> T[] toArray(IntFunction<T[]> generator) {
        synchronized (mutex) {
            return target.toArray(generator);
        }
    }

    @Override
    public boolean add(E e) {
        synchronized (mutex) {
            return target.add(e);
        }
    }

    @Override
    public boolean remove(Object o) {
        synchronized (mutex) {
            return target.remove(o);
        }
    }

    @Override
    public boolean containsAll(Collection<?> c) {
        synchronized (mutex) {
            return target.containsAll(c);
        }
    }

    @Override
    public boolean addAll(Collection<? extends E> c) {
        synchronized (mutex) {
            return target.addAll(c);
        }
    }

    @Override
    public boolean removeAll(Collection<?> c) {
        synchronized (mutex) {
            return target.removeAll(c);
        }
    }

    @Override
    public boolean retainAll(Collection<?> c) {
        synchronized (mutex) {
            return target.retainAll(c);
        }
    }

    @Override
    public void clear() {
        synchronized (mutex) {
            target.clear();
        }
    }

    @Override
    public void forEach(Consumer<? super E> action) {
        synchronized (mutex) {
            target.forEach(action);
        }
    }

    @Override
    public boolean removeIf(Predicate<? super E> filter) {
        synchronized (mutex) {
            return target.removeIf(filter);
        }
    }

    @Override
    public String toString() {
        synchronized (mutex) {
            return target.toString();
        }
    }

    @Override
    public Iterator<E> iterator() {
        return target.iterator();
    }

    @Override
    public Spliterator<E> spliterator() {
        return target.spliterator();
    }

    @Override
    public Stream<E> stream() {
        return target.stream();
    }

    @Override
    public Stream<E> parallelStream() {
        return target.stream();
    }
}
