package brickless.concurrent.util;

import java.util.Collection;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;

/** A map behind one monitor, which guards its views as well. */
class SynchronizedMap<K, V> implements Map<K, V> {
    /** What every method locks. */
    final Object mutex;
    private final Map<K, V> target;

    /** Guards {@code target} with {@code mutex}, or with the wrapper itself if that is null. */
    SynchronizedMap(Map<K, V> target, Object mutex) {
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
    public boolean containsKey(Object key) {
        synchronized (mutex) {
            return target.containsKey(key);
        }
    }

    @Override
    public boolean containsValue(Object value) {
        synchronized (mutex) {
            return target.containsValue(value);
        }
    }

    @Override
    public V get(Object key) {
        synchronized (mutex) {
            return target.get(key);
        }
    }

    @Override
    public V put(K key, V value) {
        synchronized (mutex) {
            return target.put(key, value);
        }
    }

    @Override
    public V remove(Object key) {
        synchronized (mutex) {
            return target.remove(key);
        }
    }

    @Override
    public void putAll(Map<? extends K, ? extends V> map) {
        synchronized (mutex) {
            target.putAll(map);
        }
    }

    @Override
    public void clear() {
        synchronized (mutex) {
            target.clear();
        }
    }

    @Override
    public V getOrDefault(Object key, V defaultValue) {
        synchronized (mutex) {
            return target.getOrDefault(key, defaultValue);
        }
    }

    @Override
    public void forEach(BiConsumer<? super K, ? super V> action) {
        synchronized (mutex) {
            target.forEach(action);
        }
    }

    @Override
    public void replaceAll(BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (mutex) {
            target.replaceAll(function);
        }
    }

    @Override
    public V putIfAbsent(K key, V value) {
        synchronized (mutex) {
            return target.putIfAbsent(key, value);
        }
    }

    @Override
    public boolean remove(Object key, Object value) {
        synchronized (mutex) {
            return target.remove(key, value);
        }
    }

    @Override
    public boolean replace(K key, V oldValue, V newValue) {
        synchronized (mutex) {
            return target.replace(key, oldValue, newValue);
        }
    }

    @Override
    public V replace(K key, V value) {
        synchronized (mutex) {
            return target.replace(key, value);
        }
    }

    @Override
    public V computeIfAbsent(K key, Function<? super K, ? extends V> function) {
        synchronized (mutex) {
            return target.computeIfAbsent(key, function);
        }
    }

    @Override
    public V computeIfPresent(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (mutex) {
            return target.computeIfPresent(key, function);
        }
    }

    @Override
    public V compute(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (mutex) {
            return target.compute(key, function);
        }
    }

    @Override
    public V merge(K key, V value, BiFunction<? super V, ? super V, ? extends V> function) {
        synchronized (mutex) {
            return target.merge(key, value, function);
        }
    }

    @Override
    public int hashCode() {
        synchronized (mutex) {
            return target.hashCode();
        }
    }

    @Override
    public String toString() {
        synchronized (mutex) {
            return target.toString();
        }
    }

    @Override
    public boolean equals(Object o) {
        synchronized (mutex) {
            return o == this || target.equals(o);
        }
    }

    @Override
    public Set<K> keySet() {
        synchronized (mutex) {
            return new SynchronizedSet<>(target.keySet(), mutex);
        }
    }

    @Override
    public Set<Map.Entry<K, V>> entrySet() {
        synchronized (mutex) {
            return new SynchronizedSet<>(target.entrySet(), mutex);
        }
    }

    @Override
    public Collection<V> values() {
        synchronized (mutex) {
            return new SynchronizedCollection<>(target.values(), mutex);
        }
    }
}
