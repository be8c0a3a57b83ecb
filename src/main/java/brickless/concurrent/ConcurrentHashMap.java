package brickless.concurrent;

import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * The JDK's ConcurrentHashMap, except that it holds no lock of the JDK while it calls a function of the program: the
 * four methods that compute a value exclude each other by the map's monitor. When another method changes the entry
 * meanwhile, the function is called again.
 *
 * <p>The loader only makes programs construct and extend this class; the type that they use stays the JDK's.
 */
public class ConcurrentHashMap<K, V> extends java.util.concurrent.ConcurrentHashMap<K, V> {
    private static final long serialVersionUID = 1L;

    /** Creates an empty map. */
    public ConcurrentHashMap() {
    }

    /** Creates an empty map with room for that many entries. */
    public ConcurrentHashMap(int initialCapacity) {
        super(initialCapacity);
    }

    /** Creates a map with the entries of another one. */
    public ConcurrentHashMap(Map<? extends K, ? extends V> m) {
        super(m);
    }

    /** Creates an empty map with room for that many entries. */
    public ConcurrentHashMap(int initialCapacity, float loadFactor) {
        super(initialCapacity, loadFactor);
    }

    /** Creates an empty map with room for that many entries. */
    public ConcurrentHashMap(int initialCapacity, float loadFactor, int concurrencyLevel) {
        super(initialCapacity, loadFactor, concurrencyLevel);
    }

    @Override
    public V computeIfAbsent(K key, Function<? super K, ? extends V> mappingFunction) {
        V present = get(key);
        return present != null ? present : compute(key, (k, old) -> old != null ? old : mappingFunction.apply(k));
    }

    @Override
    public V computeIfPresent(K key, BiFunction<? super K, ? super V, ? extends V> remappingFunction) {
        return compute(key, (k, old) -> old == null ? null : remappingFunction.apply(k, old));
    }

    @Override
    public V merge(K key, V value, BiFunction<? super V, ? super V, ? extends V> remappingFunction) {
        if (value == null || remappingFunction == null) {
            throw new NullPointerException();
        }
        return compute(key, (k, old) -> old == null ? value : remappingFunction.apply(old, value));
    }

    @Override
    public synchronized V compute(K key, BiFunction<? super K, ? super V, ? extends V> remappingFunction) {
        while (true) {
            V old = get(key);
            V computed = remappingFunction.apply(key, old);
            if (exchange(key, old, computed)) {
                return computed;
            }
        }
    }

    /** Puts {@code computed} in the place of {@code old} (null: no entry) unless somebody was faster. */
    private boolean exchange(K key, V old, V computed) {
        if (old == null) {
            return computed == null || putIfAbsent(key, computed) == null;
        }
        return computed == null ? remove(key, old) : replace(key, old, computed);
    }
}
