package brickless.concurrent.util;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.Collection;
import java.util.Dictionary;
import java.util.Enumeration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;

/** {@code java.util.Hashtable} on virtual monitors, with the order of iteration that programs see in the original. */
public class Hashtable<K, V> extends Dictionary<K, V> implements Map<K, V>, Cloneable, Serializable {
    private static final long serialVersionUID = 1L;

    private transient ChainedTable<K, V> table;

    /** Creates a table; IllegalArgumentException if the capacity is negative or the load factor not positive. */
    public Hashtable(int initialCapacity, float loadFactor) {
        if (initialCapacity < 0) {
            throw new IllegalArgumentException("Illegal Capacity: " + initialCapacity);
        }
        if (!(loadFactor > 0)) {
            throw new IllegalArgumentException("Illegal Load: " + loadFactor);
        }
        table = new ChainedTable<>(Math.max(initialCapacity, 1), loadFactor);
    }

    /** Creates a table; IllegalArgumentException if the capacity is negative. */
    public Hashtable(int initialCapacity) {
        this(initialCapacity, ChainedTable.LOAD_FACTOR);
    }

    /** Creates a table for 11 entries. */
    public Hashtable() {
        this(ChainedTable.CAPACITY);
    }

    /** Creates a table with the entries of a map. */
    public Hashtable(Map<? extends K, ? extends V> t) {
        this(Math.max(2 * t.size(), ChainedTable.CAPACITY));
        putAll(t);
    }

    /** Makes room for more than twice as many entries. */
    protected void rehash() {
        synchronized (this) {
            table.grow();
        }
    }

    @Override
    public Enumeration<K> keys() {
        synchronized (this) {
            return table.enumeration(Map.Entry::getKey);
        }
    }

    @Override
    public Enumeration<V> elements() {
        synchronized (this) {
            return table.enumeration(Map.Entry::getValue);
        }
    }

    /** The same as {@link #containsValue}. */
    public boolean contains(Object value) {
        return containsValue(value);
    }

    /** A table with the same entries. */
    @Override
    @SuppressWarnings("unchecked")
    public Object clone() {
        synchronized (this) {
            try {
                Hashtable<K, V> copy = (Hashtable<K, V>) super.clone();
                copy.table = table.copy();
                return copy;
            } catch (CloneNotSupportedException e) {
                throw new AssertionError(e);
            }
        }
    }

    @Override
    public int size() {
        synchronized (this) {
            return table.size();
        }
    }

    @Override
    public boolean isEmpty() {
        synchronized (this) {
            return table.isEmpty();
        }
    }

    @Override
    public boolean containsKey(Object key) {
        synchronized (this) {
            return table.containsKey(key);
        }
    }

    @Override
    public boolean containsValue(Object value) {
        synchronized (this) {
            return table.containsValue(value);
        }
    }

    @Override
    public V get(Object key) {
        synchronized (this) {
            return table.get(key);
        }
    }

    @Override
    public V put(K key, V value) {
        synchronized (this) {
            return table.put(key, value);
        }
    }

    @Override
    public V remove(Object key) {
        synchronized (this) {
            return table.remove(key);
        }
    }

    @Override
    public void putAll(Map<? extends K, ? extends V> map) {
        synchronized (this) {
            table.putAll(map);
        }
    }

    @Override
    public void clear() {
        synchronized (this) {
            table.clear();
        }
    }

    @Override
    public V getOrDefault(Object key, V defaultValue) {
        synchronized (this) {
            return table.getOrDefault(key, defaultValue);
        }
    }

    @Override
    public void forEach(BiConsumer<? super K, ? super V> action) {
        synchronized (this) {
            table.forEach(action);
        }
    }

    @Override
    public void replaceAll(BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (this) {
            table.replaceAll(function);
        }
    }

    @Override
    public V putIfAbsent(K key, V value) {
        synchronized (this) {
            return table.putIfAbsent(key, value);
        }
    }

    @Override
    public boolean remove(Object key, Object value) {
        synchronized (this) {
            return table.remove(key, value);
        }
    }

    @Override
    public boolean replace(K key, V oldValue, V newValue) {
        synchronized (this) {
            return table.replace(key, oldValue, newValue);
        }
    }

    @Override
    public V replace(K key, V value) {
        synchronized (this) {
            return table.replace(key, value);
        }
    }

    @Override
    public V computeIfAbsent(K key, Function<? super K, ? extends V> function) {
        synchronized (this) {
            return table.computeIfAbsent(key, function);
        }
    }

    @Override
    public V computeIfPresent(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (this) {
            return table.computeIfPresent(key, function);
        }
    }

    @Override
    public V compute(K key, BiFunction<? super K, ? super V, ? extends V> function) {
        synchronized (this) {
            return table.compute(key, function);
        }
    }

    @Override
    public V merge(K key, V value, BiFunction<? super V, ? super V, ? extends V> function) {
        synchronized (this) {
            return table.merge(key, value, function);
        }
    }

    @Override
    public int hashCode() {
        synchronized (this) {
            return table.hashCode();
        }
    }

    @Override
    public String toString() {
        synchronized (this) {
            return table.toString();
        }
    }

    @Override
    public boolean equals(Object o) {
        synchronized (this) {
            return o == this || table.equals(o);
        }
    }

    @Override
    public Set<K> keySet() {
        synchronized (this) {
            return new SynchronizedSet<>(table.keySet(), this);
        }
    }

    @Override
    public Set<Map.Entry<K, V>> entrySet() {
        synchronized (this) {
            return new SynchronizedSet<>(table.entrySet(), this);
        }
    }

    @Override
    public Collection<V> values() {
        synchronized (this) {
            return new SynchronizedCollection<>(table.values(), this);
        }
    }

    private void writeObject(ObjectOutputStream stream) throws IOException {
        synchronized (this) {
            stream.defaultWriteObject();
            stream.writeObject(new LinkedHashMap<>(table));
        }
    }

    @SuppressWarnings("unchecked")
    private void readObject(ObjectInputStream stream) throws IOException, ClassNotFoundException {
        stream.defaultReadObject();
        table = new ChainedTable<>(ChainedTable.CAPACITY, ChainedTable.LOAD_FACTOR);
        table.putAll((Map<K, V>) stream.readObject());
    }
}
