package brickless.concurrent.util;

import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Enumeration;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;

/**
 * The unsynchronized table behind {@link Hashtable}. Neither keys nor values may be null. Walks go from the last chain
 * to the first and, within a chain, from the newest entry to the oldest, as programs observe it in the JDK.
 */
final class ChainedTable<K, V> extends AbstractMap<K, V> {
    static final int CAPACITY = 11;
    static final float LOAD_FACTOR = 0.75f;

    private final float loadFactor;
    private Chained<K, V>[] chains;
    private int size;
    private int changes;

    private static final class Chained<K, V> extends AbstractMap.SimpleEntry<K, V> {
        private static final long serialVersionUID = 1L;

        private final transient int hash;
        private transient Chained<K, V> next;

        Chained(K key, V value, int hash, Chained<K, V> next) {
            super(key, value);
            this.hash = hash;
            this.next = next;
        }

        @Override
        public V setValue(V value) {
            return super.setValue(Objects.requireNonNull(value));
        }
    }

    ChainedTable(int capacity, float loadFactor) {
        this.loadFactor = loadFactor;
        this.chains = newChains(capacity);
    }

    @SuppressWarnings("unchecked")
    private static <K, V> Chained<K, V>[] newChains(int capacity) {
        return (Chained<K, V>[]) new Chained<?, ?>[capacity];
    }

    /** A table of the same capacity with the same entries in the same order. */
    ChainedTable<K, V> copy() {
        ChainedTable<K, V> copy = new ChainedTable<>(chains.length, loadFactor);
        List<Chained<K, V>> oldestFirst = new ArrayList<>(size);
        for (Map.Entry<K, V> entry : entrySet()) {
            oldestFirst.add(0, (Chained<K, V>) entry);
        }
        for (Chained<K, V> entry : oldestFirst) {
            copy.add(entry.getKey(), entry.getValue(), entry.hash);
        }
        return copy;
    }

    private int chainOf(int hash) {
        return (hash & Integer.MAX_VALUE) % chains.length;
    }

    private Chained<K, V> find(Object key) {
        return find(key, key.hashCode());
    }

    private Chained<K, V> find(Object key, int hash) {
        for (Chained<K, V> entry = chains[chainOf(hash)]; entry != null; entry = entry.next) {
            if (entry.hash == hash && entry.getKey().equals(key)) {
                return entry;
            }
        }
        return null;
    }

    private void add(K key, V value, int hash) {
        int chain = chainOf(hash);
        chains[chain] = new Chained<>(key, value, hash, chains[chain]);
        size++;
        changes++;
    }

    /** More than doubles the capacity. */
    void grow() {
        Chained<K, V>[] old = chains;
        chains = newChains(2 * old.length + 1);
        changes++;
        for (int i = old.length - 1; i >= 0; i--) {
            Chained<K, V> entry = old[i];
            while (entry != null) {
                Chained<K, V> rest = entry.next;
                int chain = chainOf(entry.hash);
                entry.next = chains[chain];
                chains[chain] = entry;
                entry = rest;
            }
        }
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public V get(Object key) {
        Chained<K, V> entry = find(key);
        return entry == null ? null : entry.getValue();
    }

    @Override
    public boolean containsKey(Object key) {
        return find(key) != null;
    }

    @Override
    public boolean containsValue(Object value) {
        return super.containsValue(Objects.requireNonNull(value));
    }

    @Override
    public V put(K key, V value) {
        Objects.requireNonNull(value);
        int hash = key.hashCode();
        Chained<K, V> entry = find(key, hash);
        if (entry != null) {
            return entry.setValue(value);
        }
        if (size >= (int) (chains.length * loadFactor)) {
            grow();
        }
        add(key, value, hash);
        return null;
    }

    @Override
    public V remove(Object key) {
        Chained<K, V> entry = find(key);
        if (entry == null) {
            return null;
        }
        unlink(entry);
        return entry.getValue();
    }

    private void unlink(Chained<K, V> entry) {
        int chain = chainOf(entry.hash);
        if (chains[chain] == entry) {
            chains[chain] = entry.next;
        } else {
            Chained<K, V> before = chains[chain];
            while (before.next != entry) {
                before = before.next;
            }
            before.next = entry.next;
        }
        size--;
        changes++;
    }

    @Override
    public void clear() {
        chains = newChains(chains.length);
        size = 0;
        changes++;
    }

    @Override
    public Set<Map.Entry<K, V>> entrySet() {
        return new AbstractSet<>() {
            @Override
            public int size() {
                return size;
            }

            @Override
            public Iterator<Map.Entry<K, V>> iterator() {
                return new Walk(true);
            }

            @Override
            public void clear() {
                ChainedTable.this.clear();
            }
        };
    }

    /** Unlike an iterator it does not notice changes. */
    <T> Enumeration<T> enumeration(Function<Map.Entry<K, V>, T> part) {
        Iterator<Map.Entry<K, V>> entries = new Walk(false);
        return new Enumeration<>() {
            @Override
            public boolean hasMoreElements() {
                return entries.hasNext();
            }

            @Override
            public T nextElement() {
                return part.apply(entries.next());
            }
        };
    }

    private final class Walk implements Iterator<Map.Entry<K, V>> {
        private final boolean failFast;
        private final Chained<K, V>[] walked = chains;
        private int chain = walked.length;
        private int seenChanges = changes;
        private Chained<K, V> next;
        private Chained<K, V> last;

        Walk(boolean failFast) {
            this.failFast = failFast;
            advance(null);
        }

        private void advance(Chained<K, V> candidate) {
            next = candidate;
            while (next == null && chain > 0) {
                chain--;
                next = walked[chain];
            }
        }

        private void failIfChanged() {
            if (failFast && seenChanges != changes) {
                throw new ConcurrentModificationException();
            }
        }

        @Override
        public boolean hasNext() {
            return next != null;
        }

        @Override
        public Map.Entry<K, V> next() {
            failIfChanged();
            if (next == null) {
                throw new NoSuchElementException();
            }
            last = next;
            advance(last.next);
            return last;
        }

        @Override
        public void remove() {
            if (last == null) {
                throw new IllegalStateException();
            }
            failIfChanged();
            unlink(last);
            last = null;
            seenChanges = changes;
        }
    }
}
