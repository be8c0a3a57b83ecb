package brickless.concurrent.util;

import java.util.Set;

/** A set behind one monitor. */
class SynchronizedSet<E> extends SynchronizedCollection<E> implements Set<E> {
    private final Set<E> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedSet(Set<E> target, Object mutex) {
        super(target, mutex);
        this.target = target;
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
