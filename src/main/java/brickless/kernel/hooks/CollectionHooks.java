package brickless.kernel.hooks;

import java.lang.invoke.CallSite;
import java.lang.invoke.ConstantCallSite;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.Spliterator;
import java.util.function.BinaryOperator;
import java.util.function.Function;
import java.util.stream.BaseStream;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/**
 * Collections and streams of rewritten code: {@code Set.of} and {@code Map.of} in the order given, where the JDK's
 * order changes with every start of the JVM; parallel streams on the calling thread, because the host's worker threads
 * know nothing of virtual time. Per robot.
 */
public final class CollectionHooks {
    private CollectionHooks() {}

    /**
     * Bootstrap method of a call such as {@code Set.of(a, b, c)}: collects the arguments for {@link #setOf} or
     * {@link #mapOf}.
     *
     * @param name the method here that takes them as an array
     * @param type of the call
     */
    public static CallSite collecting(MethodHandles.Lookup lookup, String name, MethodType type)
            throws ReflectiveOperationException {
        MethodType collected = MethodType.methodType(type.returnType(), Object[].class);
        MethodHandle target = MethodHandles.lookup().findStatic(CollectionHooks.class, name, collected);
        boolean isArrayAlready = type.equals(collected);
        return new ConstantCallSite(isArrayAlready ? target
                : target.asCollector(Object[].class, type.parameterCount()).asType(type));
    }

    /** {@code Set.of(elements)}. */
    public static Set<Object> setOf(Object... elements) {
        Set<Object> set = new LinkedHashSet<>();
        for (Object element : elements) {
            if (!set.add(Objects.requireNonNull(element))) {
                throw new IllegalArgumentException("duplicate element: " + TextHooks.text(element));
            }
        }
        return Collections.unmodifiableSet(set);
    }

    /** {@code Set.copyOf(elements)}. */
    public static Set<Object> setCopy(Collection<?> elements) {
        Set<Object> set = new LinkedHashSet<>();
        for (Object element : elements) {
            set.add(Objects.requireNonNull(element));
        }
        return Collections.unmodifiableSet(set);
    }

    /** {@code Map.of(key, value, …)}. */
    public static Map<Object, Object> mapOf(Object... keysAndValues) {
        Map<Object, Object> map = new LinkedHashMap<>();
        for (int i = 0; i < keysAndValues.length; i += 2) {
            putNew(map, keysAndValues[i], keysAndValues[i + 1]);
        }
        return Collections.unmodifiableMap(map);
    }

    /** {@code Map.ofEntries(entries)}. */
    public static Map<Object, Object> mapOfEntries(Map.Entry<?, ?>[] entries) {
        Map<Object, Object> map = new LinkedHashMap<>();
        for (Map.Entry<?, ?> entry : entries) {
            putNew(map, entry.getKey(), entry.getValue());
        }
        return Collections.unmodifiableMap(map);
    }

    /** {@code Map.copyOf(map)}. */
    public static Map<Object, Object> mapCopy(Map<?, ?> original) {
        Map<Object, Object> map = new LinkedHashMap<>();
        original.forEach((key, value) -> putNew(map, key, value));
        return Collections.unmodifiableMap(map);
    }

    private static void putNew(Map<Object, Object> map, Object key, Object value) {
        if (map.put(Objects.requireNonNull(key), Objects.requireNonNull(value)) != null) {
            throw new IllegalArgumentException("duplicate key: " + TextHooks.text(key));
        }
    }

    /** {@code Collectors.toSet()}. */
    public static <T> Collector<T, ?, ?> toSet() {
        return Collectors.toCollection(() -> new ProgramHashSet<T>());
    }

    /** {@code Collectors.groupingBy(key)}. */
    public static <T, K> Collector<T, ?, ?> groupingBy(Function<T, K> key) {
        return Collectors.groupingBy(key, () -> new ProgramHashMap<K, List<T>>(), Collectors.toList());
    }

    /** {@code Collectors.groupingBy(key, downstream)}. */
    public static <T, K, D> Collector<T, ?, ?> groupingBy(Function<T, K> key, Collector<T, ?, D> downstream) {
        return Collectors.groupingBy(key, () -> new ProgramHashMap<K, D>(), downstream);
    }

    /** {@code Collectors.toMap(key, value)}. */
    public static <T, K, V> Collector<T, ?, ?> toMap(Function<T, K> key, Function<T, V> value) {
        return Collectors.toMap(key, value, CollectionHooks::refuseDuplicate, () -> new ProgramHashMap<K, V>());
    }

    private static <V> V refuseDuplicate(V first, V second) {
        throw new IllegalStateException("Duplicate key (attempted merging values " + TextHooks.text(first) + " and "
                + TextHooks.text(second) + ")");
    }

    /** {@code Collectors.toMap(key, value, merging)}. */
    public static <T, K, V> Collector<T, ?, ?> toMap(Function<T, K> key, Function<T, V> value,
            BinaryOperator<V> merging) {
        return Collectors.toMap(key, value, merging, () -> new ProgramHashMap<K, V>());
    }

    /** {@code collection.parallelStream()}. */
    public static <T> Stream<T> parallelStream(Collection<T> collection) {
        return collection.stream();
    }

    /** {@code stream.parallel()}. */
    public static BaseStream<?, ?> parallel(BaseStream<?, ?> stream) {
        return stream.sequential();
    }

    /** {@code stream.parallel()}. */
    public static IntStream parallel(IntStream stream) {
        return stream.sequential();
    }

    /** {@code stream.parallel()}. */
    public static LongStream parallel(LongStream stream) {
        return stream.sequential();
    }

    /** {@code stream.parallel()}. */
    public static DoubleStream parallel(DoubleStream stream) {
        return stream.sequential();
    }

    /** {@code StreamSupport.stream(source, parallel)}. */
    public static <T> Stream<T> stream(Spliterator<T> source, boolean parallel) {
        return StreamSupport.stream(source, false);
    }

    /** {@code Arrays.parallelSort(values)}. */
    public static void sort(int[] values) {
        Arrays.sort(values);
    }

    /** {@code Arrays.parallelSort(values)}. */
    public static void sort(double[] values) {
        Arrays.sort(values);
    }

    /** {@code Arrays.parallelSort(values)}. */
    public static void sort(float[] values) {
        Arrays.sort(values);
    }

    /** {@code Arrays.parallelSort(values)}. */
    public static void sort(long[] values) {
        Arrays.sort(values);
    }

    /** {@code Arrays.parallelSort(values)}. */
    public static void sort(Comparable<?>[] values) {
        Arrays.sort(values);
    }
}
