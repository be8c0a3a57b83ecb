package brickless.concurrent.util;

import java.util.Comparator;
import java.util.SortedMap;

/** A sorted map behind one monitor. */
class SynchronizedSortedMap<K, V> extends SynchronizedMap<K, V> implements SortedMap<K, V> {
    private final SortedMap<K, V> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedSortedMap(SortedMap<K, V> target, Object mutex) {
        super(target, mutex);
        this.target = target;
    }

    @Override
    public Comparator<? super K> comparator() {
        synchronized (mutex) {
            return target.comparator();
        }
    }

    @Override
    public K firstKey() {
        synchronized (mutex) {
            return target.firstKey();
        }
    }

    @Override
    public K lastKey() {
        synchronized (mutex) {
            return target.lastKey();
        }
    }

    @Override
    public SortedMap<K, V> subMap(K fromKey, K toKey) {
        synchronized (mutex) {
            return new SynchronizedSortedMap<>(target.subMap(fromKey, toKey), mutex);
        }
    }

    @Override
    public SortedMap<K, V> headMap(K toKey) {
        synchronized (mutex) {
            return new SynchronizedSortedMap<>(target.headMap(toKey), mutex);
        }
    }

    @Override
    public SortedMap<K, V> tailMap(K fromKey) {
        synchronized (mutex) {
            return new SynchronizedSortedMap<>(target.tailMap(fromKey), mutex);
        }
    }
}
