package brickless.concurrent.util;

import java.io.Serializable;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Enumeration;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;

/** {@code java.util.Vector} on virtual monitors. */
public class Vector<E> extends AbstractList<E> implements List<E>, RandomAccess, Cloneable, Serializable {
    private static final long serialVersionUID = 1L;
    private static final int DEFAULT_CAPACITY = 10;

    /** The elements, followed by nulls. */
    protected Object[] elementData;
    /** Number of elements. */
    protected int elementCount;
    /** By how much the capacity grows; zero or less: it doubles. */
    protected int capacityIncrement;

    /** Creates a vector; IllegalArgumentException if the capacity is negative. */
    public Vector(int initialCapacity, int capacityIncrement) {
        if (initialCapacity < 0) {
            throw new IllegalArgumentException("Illegal Capacity: " + initialCapacity);
        }
        this.elementData = new Object[initialCapacity];
        this.capacityIncrement = capacityIncrement;
    }

    /** Creates a vector; IllegalArgumentException if the capacity is negative. */
    public Vector(int initialCapacity) {
        this(initialCapacity, 0);
    }

    /** Creates a vector of capacity 10. */
    public Vector() {
        this(DEFAULT_CAPACITY);
    }

    /** Creates a vector with the elements of a collection. */
    public Vector(Collection<? extends E> c) {
        elementData = Arrays.copyOf(c.toArray(), c.size(), Object[].class);
        elementCount = elementData.length;
    }

    /** Copies the elements into an array that is long enough. */
    public synchronized void copyInto(Object[] anArray) {
        System.arraycopy(elementData, 0, anArray, 0, elementCount);
    }

    /** Makes the capacity as large as the size. */
    public synchronized void trimToSize() {
        modCount++;
        elementData = Arrays.copyOf(elementData, elementCount);
    }

    /** Makes the capacity at least that large. */
    public synchronized void ensureCapacity(int minCapacity) {
        modCount++;
        if (minCapacity > elementData.length) {
            int grown = elementData.length + (capacityIncrement > 0 ? capacityIncrement : elementData.length);
            elementData = Arrays.copyOf(elementData, Math.max(grown, minCapacity));
        }
    }

    /** Drops elements at the end, or appends nulls. */
    public synchronized void setSize(int newSize) {
        if (newSize < 0) {
            throw new ArrayIndexOutOfBoundsException(newSize);
        }
        ensureCapacity(newSize);
        if (newSize < elementCount) {
            Arrays.fill(elementData, newSize, elementCount, null);
        }
        elementCount = newSize;
    }

    /** Number of elements that fit before the vector grows. */
    public synchronized int capacity() {
        return elementData.length;
    }

    @Override
    public synchronized int size() {
        return elementCount;
    }

    @Override
    public synchronized boolean isEmpty() {
        return elementCount == 0;
    }

    /** The elements in order; does not notice changes. */
    public Enumeration<E> elements() {
        return new Enumeration<>() {
            private int next;

            @Override
            public boolean hasMoreElements() {
                return next < size();
            }

            @Override
            public E nextElement() {
                synchronized (Vector.this) {
                    if (next >= elementCount) {
                        throw new NoSuchElementException();
                    }
                    return elementAt(next++);
                }
            }
        };
    }

    @Override
    public boolean contains(Object o) {
        return indexOf(o) >= 0;
    }

    @Override
    public int indexOf(Object o) {
        return indexOf(o, 0);
    }

    /** First place of an element from {@code index} on, or -1. */
    public synchronized int indexOf(Object o, int index) {
        for (int i = index; i < elementCount; i++) {
            if (Objects.equals(o, elementData[i])) {
                return i;
            }
        }
        return -1;
    }

    @Override
    public synchronized int lastIndexOf(Object o) {
        return lastIndexOf(o, elementCount - 1);
    }

    /** Last place of an element up to {@code index}, or -1. */
    public synchronized int lastIndexOf(Object o, int index) {
        if (index >= elementCount) {
            throw new IndexOutOfBoundsException(index + " >= " + elementCount);
        }
        for (int i = index; i >= 0; i--) {
            if (Objects.equals(o, elementData[i])) {
                return i;
            }
        }
        return -1;
    }

    /** The element at a place. */
    @SuppressWarnings("unchecked")
    public synchronized E elementAt(int index) {
        requireElement(index);
        return (E) elementData[index];
    }

    private void requireElement(int index) {
        if (index < 0 || index >= elementCount) {
            throw new ArrayIndexOutOfBoundsException(index + " >= " + elementCount);
        }
    }

    /** The first element; NoSuchElementException if there is none. */
    public synchronized E firstElement() {
        requireNotEmpty();
        return elementAt(0);
    }

    /** The last element; NoSuchElementException if there is none. */
    public synchronized E lastElement() {
        requireNotEmpty();
        return elementAt(elementCount - 1);
    }

    private void requireNotEmpty() {
        if (elementCount == 0) {
            throw new NoSuchElementException();
        }
    }

    /** Replaces the element at a place. */
    public synchronized void setElementAt(E obj, int index) {
        requireElement(index);
        elementData[index] = obj;
    }

    /** Removes the element at a place. */
    public synchronized void removeElementAt(int index) {
        requireElement(index);
        removeRange(index, index + 1);
    }

    /** Inserts an element at a place, or at the end. */
    public synchronized void insertElementAt(E obj, int index) {
        if (index < 0 || index > elementCount) {
            throw new ArrayIndexOutOfBoundsException(index + " > " + elementCount);
        }
        ensureCapacity(elementCount + 1);
        System.arraycopy(elementData, index, elementData, index + 1, elementCount - index);
        elementData[index] = obj;
        elementCount++;
    }

    /** Appends an element. */
    public synchronized void addElement(E obj) {
        insertElementAt(obj, elementCount);
    }

    /** Removes the first such element. */
    public synchronized boolean removeElement(Object obj) {
        int index = indexOf(obj);
        if (index >= 0) {
            removeElementAt(index);
        }
        return index >= 0;
    }

    /** Removes all elements. */
    public synchronized void removeAllElements() {
        removeRange(0, elementCount);
    }

    /** A vector with the same elements. */
    @Override
    public synchronized Object clone() {
        try {
            Vector<?> copy = (Vector<?>) super.clone();
            copy.elementData = elementData.clone();
            copy.modCount = 0;
            return copy;
        } catch (CloneNotSupportedException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public synchronized Object[] toArray() {
        return Arrays.copyOf(elementData, elementCount);
    }

    @Override
    public synchronized <T> T[] toArray(T[] a) {
        return super.toArray(a);
    }

    @Override
    public synchronized E get(int index) {
        return elementAt(index);
    }

    @Override
    public synchronized E set(int index, E element) {
        E previous = elementAt(index);
        elementData[index] = element;
        return previous;
    }

    @Override
    public synchronized boolean add(E e) {
        addElement(e);
        return true;
    }

    @Override
    public boolean remove(Object o) {
        return removeElement(o);
    }

    @Override
    public void add(int index, E element) {
        insertElementAt(element, index);
    }

    @Override
    public synchronized E remove(int index) {
        E removed = elementAt(index);
        removeElementAt(index);
        return removed;
    }

    @Override
    public void clear() {
        removeAllElements();
    }

    @Override
    public synchronized boolean containsAll(Collection<?> c) {
        return super.containsAll(c);
    }

    @Override
    public synchronized boolean addAll(Collection<? extends E> c) {
        return addAll(elementCount, c);
    }

    @Override
    public synchronized boolean removeAll(Collection<?> c) {
        return super.removeAll(c);
    }

    @Override
    public synchronized boolean retainAll(Collection<?> c) {
        return super.retainAll(c);
    }

    @Override
    public synchronized boolean removeIf(Predicate<? super E> filter) {
        return super.removeIf(filter);
    }

    @Override
    @SuppressWarnings("unchecked")
    public synchronized boolean addAll(int index, Collection<? extends E> c) {
        if (index < 0 || index > elementCount) {
            throw new ArrayIndexOutOfBoundsException(index);
        }
        Object[] added = c.toArray();
        for (int i = 0; i < added.length; i++) {
            insertElementAt((E) added[i], index + i);
        }
        return added.length > 0;
    }

    @Override
    public synchronized boolean equals(Object o) {
        return super.equals(o);
    }

    @Override
    public synchronized int hashCode() {
        return super.hashCode();
    }

    @Override
    public synchronized String toString() {
        return super.toString();
    }

    @Override
    public synchronized List<E> subList(int fromIndex, int toIndex) {
        return SynchronizedList.of(super.subList(fromIndex, toIndex), this);
    }

    @Override
    protected synchronized void removeRange(int fromIndex, int toIndex) {
        modCount++;
        System.arraycopy(elementData, toIndex, elementData, fromIndex, elementCount - toIndex);
        int newCount = elementCount - (toIndex - fromIndex);
        Arrays.fill(elementData, newCount, elementCount, null);
        elementCount = newCount;
    }

    @Override
    public synchronized void forEach(Consumer<? super E> action) {
        super.forEach(action);
    }

    @Override
    public synchronized void replaceAll(UnaryOperator<E> operator) {
        super.replaceAll(operator);
    }

    @Override
    public synchronized void sort(Comparator<? super E> c) {
        super.sort(c);
    }
}
