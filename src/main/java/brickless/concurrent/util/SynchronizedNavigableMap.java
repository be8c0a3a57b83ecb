package brickless.concurrent.util;

import java.util.Map;
import java.util.NavigableMap;
import java.util.NavigableSet;

/** A navigable map behind one monitor. */
final class SynchronizedNavigableMap<K, V> extends SynchronizedSortedMap<K, V> implements NavigableMap<K, V> {
    private final NavigableMap<K, V> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedNavigableMap(NavigableMap<K, V> target, Object mutex) {
        super(target, mutex);
        this.target = target;
    }

    private NavigableMap<K, V> guard(NavigableMap<K, V> view) {
        return new SynchronizedNavigableMap<>(view, mutex);
    }

    @Override
    public Map.Entry<K, V> lowerEntry(K key) {
        synchronized (mutex) {
            return target.lowerEntry(key);
        }
    }

    @Override
    public K lowerKey(K key) {
        synchronized (mutex) {
            return target.lowerKey(key);
        }
    }

    @Override
    public Map.Entry<K, V> floorEntry(K key) {
        synchronized (mutex) {
            return target.floorEntry(key);
        }
    }

    @Override
    public K floorKey(K key) {
        synchronized (mutex) {
            return target.floorKey(key);
        }
    }

    @Override
    public Map.Entry<K, V> ceilingEntry(K key) {
        synchronized (mutex) {
            return target.ceilingEntry(key);
        }
    }

    @Override
    public K ceilingKey(K key) {
        synchronized (mutex) {
            return target.ceilingKey(key);
        }
    }

    @Override
    public Map.Entry<K, V> higherEntry(K key) {
        synchronized (mutex) {
            return target.higherEntry(key);
        }
    }

    @Override
    public K higherKey(K key) {
        synchronized (mutex) {
            return target.higherKey(key);
        }
    }

    @Override
    public Map.Entry<K, V> firstEntry() {
        synchronized (mutex) {
            return target.firstEntry();
        }
    }

    @Override
    public Map.Entry<K, V> lastEntry() {
        synchronized (mutex) {
            return target.lastEntry();
        }
    }

    @Override
    public Map.Entry<K, V> pollFirstEntry() {
        synchronized (mutex) {
            return target.pollFirstEntry();
        }
    }

    @Override
    public Map.Entry<K, V> pollLastEntry() {
        synchronized (mutex) {
            return target.pollLastEntry();
        }
    }

    @Override
    public NavigableMap<K, V> descendingMap() {
        synchronized (mutex) {
            return guard(target.descendingMap());
        }
    }

    @Override
    public NavigableSet<K> keySet() {
        return navigableKeySet();
    }

    @Override
    public NavigableSet<K> navigableKeySet() {
        synchronized (mutex) {
            return new SynchronizedNavigableSet<>(target.navigableKeySet(), mutex);
        }
    }

    @Override
    public NavigableSet<K> descendingKeySet() {
        synchronized (mutex) {
            return new SynchronizedNavigableSet<>(target.descendingKeySet(), mutex);
        }
    }

    @Override
    public NavigableMap<K, V> subMap(K fromKey, K toKey) {
        return subMap(fromKey, true, toKey, false);
    }

    @Override
    public NavigableMap<K, V> headMap(K toKey) {
        return headMap(toKey, false);
    }

    @Override
    public NavigableMap<K, V> tailMap(K fromKey) {
        return tailMap(fromKey, true);
    }

    @Override
    public NavigableMap<K, V> subMap(K fromKey, boolean fromInclusive, K toKey, boolean toInclusive) {
        synchronized (mutex) {
            return guard(target.subMap(fromKey, fromInclusive, toKey, toInclusive));
        }
    }

    @Override
    public NavigableMap<K, V> headMap(K toKey, boolean inclusive) {
        synchronized (mutex) {
            return guard(target.headMap(toKey, inclusive));
        }
    }

    @Override
    public NavigableMap<K, V> tailMap(K fromKey, boolean inclusive) {
        synchronized (mutex) {
            return guard(target.tailMap(fromKey, inclusive));
        }
    }
}
