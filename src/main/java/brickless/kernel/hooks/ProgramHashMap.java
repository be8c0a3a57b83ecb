package brickless.kernel.hooks;

import java.util.AbstractSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * What {@code new HashMap} and {@code extends HashMap} become in a rewritten program: the JDK's order for keys with
 * hash codes of their own, and an order that is the same in every run for all others. Serialized as a plain HashMap.
 * Per robot; like the original not thread-safe.
 */
public class ProgramHashMap<K, V> extends HashMap<K, V> {
    private static final long serialVersionUID = 1L;
    private static final float DEFAULT_LOAD_FACTOR = 0.75f;

    private transient HashMap<Object, V> table;

    /** An empty map. */
    public ProgramHashMap() {
        table = new HashMap<>();
    }

    /** An empty map with some capacity. */
    public ProgramHashMap(int initialCapacity) {
        table = new HashMap<>(initialCapacity);
    }

    /** An empty map with some capacity and load factor. */
    public ProgramHashMap(int initialCapacity, float loadFactor) {
        table = new HashMap<>(initialCapacity, loadFactor);
    }

    /** A copy. */
    public ProgramHashMap(Map<? extends K, ? extends V> original) {
        table = new HashMap<>((int) (original.size() / DEFAULT_LOAD_FACTOR + 1));
        original.forEach((key, value) -> table.put(StableKey.of(key), value));
    }

    @Override
    public int size() {
        return table.size();
    }

    @Override
    public boolean isEmpty() {
        return table.isEmpty();
    }

    @Override
    public V get(Object key) {
        return table.get(StableKey.of(key));
    }

    @Override
    public V getOrDefault(Object key, V otherwise) {
        return table.getOrDefault(StableKey.of(key), otherwise);
    }

    @Override
    public boolean containsKey(Object key) {
        return table.containsKey(StableKey.of(key));
    }

    @Override
    public boolean containsValue(Object value) {
        return table.containsValue(value);
    }

    @Override
    public V put(K key, V value) {
        return table.put(StableKey.of(key), value);
    }

    @Override
    public void putAll(Map<? extends K, ? extends V> added) {
        added.forEach(this::put);
    }

    @Override
    public V putIfAbsent(K key, V value) {
        return table.putIfAbsent(StableKey.of(key), value);
    }

    @Override
    public V remove(Object key) {
        return table.remove(StableKey.of(key));
    }

    @Override
    public boolean remove(Object key, Object value) {
        return table.remove(StableKey.of(key), value);
    }

    @Override
    public V replace(K key, V value) {
        return table.replace(StableKey.of(key), value);
    }

    @Override
    public boolean replace(K key, V oldValue, V newValue) {
        return table.replace(StableKey.of(key), oldValue, newValue);
    }

    @Override
    public void clear() {
        table.clear();
    }

    @Override
    public V computeIfAbsent(K key, Function<? super K, ? extends V> function) {
        Objects.requireNonNull(function);
        return table.computeIfAbsent(StableKey.of(key), stored -> function.apply(key));
    }

    @Override
    public V computeIfPresent(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        Objects.requireNonNull(function);
        return table.computeIfPresent(StableKey.of(key), (stored, value) -> function.apply(key, value));
    }

    @Override
    public V compute(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        Objects.requireNonNull(function);
        return table.compute(StableKey.of(key), (stored, value) -> function.apply(key, value));
    }

    @Override
    public V merge(K key, V value, BiFunction<? super V, ? super V, ? extends V> function) {
        return table.merge(StableKey.of(key), value, function);
    }

    @Override
    @SuppressWarnings("unchecked")
    public void forEach(BiConsumer<? super K, ? super V> action) {
        Objects.requireNonNull(action);
        table.forEach((stored, value) -> action.accept((K) StableKey.original(stored), value));
    }

    @Override
    @SuppressWarnings("unchecked")
    public void replaceAll(BiFunction<? super K, ? super V, ? extends V> function) {
        Objects.requireNonNull(function);
        table.replaceAll((stored, value) -> function.apply((K) StableKey.original(stored), value));
    }

    @Override
    @SuppressWarnings("unchecked")
    public Object clone() {
        ProgramHashMap<K, V> copy = (ProgramHashMap<K, V>) super.clone();
        copy.forgetInherited();
        copy.table = (HashMap<Object, V>) table.clone();
        return copy;
    }

    /** The original's clone has copied the entries into a table that is not used here. */
    private void forgetInherited() {
        super.clear();
    }

    private Object writeReplace() {
        HashMap<K, V> plain = new HashMap<>();
        forEach(plain::put);
        return plain;
    }

    @Override
    public Set<K> keySet() {
        return new Keys();
    }

    @Override
    public Collection<V> values() {
        return table.values();
    }

    @Override
    public Set<Map.Entry<K, V>> entrySet() {
        return new Entries();
    }

    private final class Keys extends AbstractSet<K> {
        @Override
        public int size() {
            return table.size();
        }

        @Override
        public boolean contains(Object key) {
            return containsKey(key);
        }

        @Override
        public boolean remove(Object key) {
            return table.keySet().remove(StableKey.of(key));
        }

        @Override
        public void clear() {
            table.clear();
        }

        @Override
        public Iterator<K> iterator() {
            Iterator<Object> stored = table.keySet().iterator();
            return new Iterator<K>() {
                @Override
                public boolean hasNext() {
                    return stored.hasNext();
                }

                @Override
                @SuppressWarnings("unchecked")
                public K next() {
                    return (K) StableKey.original(stored.next());
                }

                @Override
                public void remove() {
                    stored.remove();
                }
            };
        }
    }

    private final class Entries extends AbstractSet<Map.Entry<K, V>> {
        @Override
        public int size() {
            return table.size();
        }

        @Override
        public boolean contains(Object entry) {
            return entry instanceof Map.Entry && containsKey(((Map.Entry<?, ?>) entry).getKey())
                    && Objects.equals(get(((Map.Entry<?, ?>) entry).getKey()), ((Map.Entry<?, ?>) entry).getValue());
        }

        @Override
        public boolean remove(Object entry) {
            if (!(entry instanceof Map.Entry)) {
                return false;
            }
            Map.Entry<?, ?> removed = (Map.Entry<?, ?>) entry;
            return ProgramHashMap.this.remove(removed.getKey(), removed.getValue());
        }

        @Override
        public void clear() {
            table.clear();
        }

        @Override
        public Iterator<Map.Entry<K, V>> iterator() {
            Iterator<Map.Entry<Object, V>> stored = table.entrySet().iterator();
            return new Iterator<Map.Entry<K, V>>() {
                @Override
                public boolean hasNext() {
                    return stored.hasNext();
                }

                @Override
                public Map.Entry<K, V> next() {
                    return new StableKey.Entry<>(stored.next());
                }

                @Override
                public void remove() {
                    stored.remove();
                }
            };
        }
    }
}
