package brickless.concurrent.util;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;

/** The {@code synchronized…} methods of {@code java.util.Collections}. */
public final class SynchronizedCollections {
    private SynchronizedCollections() {
    }

    /** {@code Collections.synchronizedCollection}: the wrapper's own monitor guards it. */
    public static <T> Collection<T> synchronizedCollection(Collection<T> c) {
        return new SynchronizedCollection<>(c, null);
    }

    /** {@code Collections.synchronizedSet}: the wrapper's own monitor guards it. */
    public static <T> Set<T> synchronizedSet(Set<T> s) {
        return new SynchronizedSet<>(s, null);
    }

    /** {@code Collections.synchronizedSortedSet}: the wrapper's own monitor guards it. */
    public static <T> SortedSet<T> synchronizedSortedSet(SortedSet<T> s) {
        return new SynchronizedSortedSet<>(s, null);
    }

    /** {@code Collections.synchronizedNavigableSet}: the wrapper's own monitor guards it. */
    public static <T> NavigableSet<T> synchronizedNavigableSet(NavigableSet<T> s) {
        return new SynchronizedNavigableSet<>(s, null);
    }

    /** {@code Collections.synchronizedList}: the wrapper's own monitor guards it. */
    public static <T> List<T> synchronizedList(List<T> list) {
        return SynchronizedList.of(list, null);
    }

    /** {@code Collections.synchronizedMap}: the wrapper's own monitor guards it. */
    public static <K, V> Map<K, V> synchronizedMap(Map<K, V> m) {
        return new SynchronizedMap<>(m, null);
    }

    /** {@code Collections.synchronizedSortedMap}: the wrapper's own monitor guards it. */
    public static <K, V> SortedMap<K, V> synchronizedSortedMap(SortedMap<K, V> m) {
        return new SynchronizedSortedMap<>(m, null);
    }

    /** {@code Collections.synchronizedNavigableMap}: the wrapper's own monitor guards it. */
    public static <K, V> NavigableMap<K, V> synchronizedNavigableMap(NavigableMap<K, V> m) {
        return new SynchronizedNavigableMap<>(m, null);
    }
}
