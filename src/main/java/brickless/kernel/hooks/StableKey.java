package brickless.kernel.hooks;

import java.util.Map;
import java.util.Objects;

/**
 * Stands in a hash table for a key whose hash code is the host's (an enum constant, a class, an array, a plain object,
 * a lambda), so that the order of the table is the same in every run. All such keys are equal to themselves only. Per
 * robot.
 */
final class StableKey {
    private final Object key;
    private final int hash;

    private StableKey(Object key) {
        this.key = key;
        hash = IdentityHashes.hashCode(key);
    }

    /** What to store for a key: the key itself if its hash code is its own. */
    static Object of(Object key) {
        if (key == null || key instanceof String || key instanceof Integer || !IdentityHashes.isHosts(key)) {
            return key;
        }
        return new StableKey(key);
    }

    /** The key that is stored as {@code stored}. */
    static Object original(Object stored) {
        return stored instanceof StableKey ? ((StableKey) stored).key : stored;
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof StableKey && ((StableKey) other).key == key;
    }

    /** An entry of a hash table as the program sees it. */
    static final class Entry<K, V> implements Map.Entry<K, V> {
        private final Map.Entry<Object, V> stored;

        Entry(Map.Entry<Object, V> stored) {
            this.stored = stored;
        }

        @Override
        @SuppressWarnings("unchecked")
        public K getKey() {
            return (K) original(stored.getKey());
        }

        @Override
        public V getValue() {
            return stored.getValue();
        }

        @Override
        public V setValue(V value) {
            return stored.setValue(value);
        }

        @Override
        public int hashCode() {
            return IdentityHashes.hashCodeOrZero(getKey()) ^ IdentityHashes.hashCodeOrZero(getValue());
        }

        @Override
        public boolean equals(Object other) {
            if (!(other instanceof Map.Entry)) {
                return false;
            }
            Map.Entry<?, ?> entry = (Map.Entry<?, ?>) other;
            return Objects.equals(getKey(), entry.getKey()) && Objects.equals(getValue(), entry.getValue());
        }

        @Override
        public String toString() {
            return TextHooks.text(getKey()) + "=" + TextHooks.text(getValue());
        }
    }
}
