package brickless.kernel.hooks;

import java.util.Collection;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Spliterator;
import java.util.Spliterators;

/**
 * What {@code new HashSet} and {@code extends HashSet} become in a rewritten program; see {@link ProgramHashMap}. Per
 * robot.
 */
public class ProgramHashSet<E> extends HashSet<E> {
    private static final long serialVersionUID = 1L;
    private static final float DEFAULT_LOAD_FACTOR = 0.75f;
    private static final int DEFAULT_CAPACITY = 16;

    private transient ProgramHashMap<E, Boolean> elements;

    /** An empty set. */
    public ProgramHashSet() {
        elements = new ProgramHashMap<>();
    }

    /** An empty set with some capacity. */
    public ProgramHashSet(int initialCapacity) {
        elements = new ProgramHashMap<>(initialCapacity);
    }

    /** An empty set with some capacity and load factor. */
    public ProgramHashSet(int initialCapacity, float loadFactor) {
        elements = new ProgramHashMap<>(initialCapacity, loadFactor);
    }

    /** A copy. */
    public ProgramHashSet(Collection<? extends E> original) {
        elements = new ProgramHashMap<>(Math.max((int) (original.size() / DEFAULT_LOAD_FACTOR) + 1, DEFAULT_CAPACITY));
        addAll(original);
    }

    @Override
    public int size() {
        return elements.size();
    }

    @Override
    public boolean isEmpty() {
        return elements.isEmpty();
    }

    @Override
    public boolean contains(Object element) {
        return elements.containsKey(element);
    }

    @Override
    public boolean add(E element) {
        return elements.put(element, Boolean.TRUE) == null;
    }

    @Override
    public boolean remove(Object element) {
        return elements.remove(element) != null;
    }

    @Override
    public void clear() {
        elements.clear();
    }

    @Override
    public Iterator<E> iterator() {
        return elements.keySet().iterator();
    }

    @Override
    public Spliterator<E> spliterator() {
        return Spliterators.spliterator(this, Spliterator.DISTINCT);
    }

    @Override
    public Object[] toArray() {
        return elements.keySet().toArray();
    }

    @Override
    public <T> T[] toArray(T[] array) {
        return elements.keySet().toArray(array);
    }

    @Override
    @SuppressWarnings("unchecked")
    public Object clone() {
        ProgramHashSet<E> copy = (ProgramHashSet<E>) super.clone();
        copy.elements = (ProgramHashMap<E, Boolean>) elements.clone();
        return copy;
    }

    private Object writeReplace() {
        return new HashSet<>(elements.keySet());
    }
}
