package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.concurrent.BlockingDeque;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.LinkedBlockingDeque} on virtual monitors. */
public class LinkedBlockingDeque<E> extends GuardedQueue<E> implements BlockingDeque<E> {
    private final Deque<E> deque;

    /** Creates a deque without a limit. */
    public LinkedBlockingDeque() {
        this(Integer.MAX_VALUE);
    }

    /** Creates a deque; IllegalArgumentException if the capacity is less than 1. */
    public LinkedBlockingDeque(int capacity) {
        this(new ArrayDeque<>(), ArrayBlockingQueue.requirePositive(capacity));
    }

    /** Creates a deque without a limit that holds the elements. */
    public LinkedBlockingDeque(Collection<? extends E> c) {
        this();
        addAll(c);
    }

    private LinkedBlockingDeque(Deque<E> deque, int capacity) {
        super(deque, capacity);
        this.deque = deque;
    }

    @Override
    public boolean add(E e) {
        addLast(e);
        return true;
    }

    @Override
    public void addFirst(E e) {
        requireRoom(offerFirst(e));
    }

    @Override
    public void addLast(E e) {
        requireRoom(offerLast(e));
    }

    private static void requireRoom(boolean inserted) {
        if (!inserted) {
            throw new IllegalStateException("Deque full");
        }
    }

    @Override
    public boolean offerFirst(E e) {
        Objects.requireNonNull(e);
        synchronized (guard) {
            if (!hasRoom()) {
                return false;
            }
            deque.addFirst(e);
            guard.notifyAll();
            return true;
        }
    }

    @Override
    public boolean offerLast(E e) {
        return offer(e);
    }

    @Override
    public void putFirst(E e) throws InterruptedException {
        insertFirst(e, Deadline.NEVER);
    }

    @Override
    public void putLast(E e) throws InterruptedException {
        put(e);
    }

    @Override
    public boolean offerFirst(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return insertFirst(e, Deadline.after(timeout, unit));
    }

    private boolean insertFirst(E e, Deadline deadline) throws InterruptedException {
        Objects.requireNonNull(e);
        failIfInterrupted();
        synchronized (guard) {
            return awaitRoom(deadline) && offerFirst(e);
        }
    }

    @Override
    public boolean offerLast(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return offer(e, timeout, unit);
    }

    @Override
    public E removeFirst() {
        return requireElement(pollFirst());
    }

    @Override
    public E removeLast() {
        return requireElement(pollLast());
    }

    private static <T> T requireElement(T element) {
        if (element == null) {
            throw new NoSuchElementException();
        }
        return element;
    }

    @Override
    public E pollFirst() {
        return poll();
    }

    @Override
    public E pollLast() {
        synchronized (guard) {
            E last = deque.pollLast();
            guard.notifyAll();
            return last;
        }
    }

    @Override
    public E takeFirst() throws InterruptedException {
        return take();
    }

    @Override
    public E takeLast() throws InterruptedException {
        return removeLast(Deadline.NEVER);
    }

    @Override
    public E pollFirst(long timeout, TimeUnit unit) throws InterruptedException {
        return poll(timeout, unit);
    }

    @Override
    public E pollLast(long timeout, TimeUnit unit) throws InterruptedException {
        return removeLast(Deadline.after(timeout, unit));
    }

    private E removeLast(Deadline deadline) throws InterruptedException {
        failIfInterrupted();
        synchronized (guard) {
            return awaitReady(deadline) ? pollLast() : null;
        }
    }

    @Override
    public E getFirst() {
        return requireElement(peekFirst());
    }

    @Override
    public E getLast() {
        return requireElement(peekLast());
    }

    @Override
    public E peekFirst() {
        return peek();
    }

    @Override
    public E peekLast() {
        synchronized (guard) {
            return deque.peekLast();
        }
    }

    @Override
    public boolean removeFirstOccurrence(Object o) {
        return remove(o);
    }

    @Override
    public boolean removeLastOccurrence(Object o) {
        synchronized (guard) {
            boolean removed = deque.removeLastOccurrence(o);
            guard.notifyAll();
            return removed;
        }
    }

    @Override
    public void push(E e) {
        addFirst(e);
    }

    @Override
    public E pop() {
        return removeFirst();
    }

    @Override
    public Iterator<E> descendingIterator() {
        synchronized (guard) {
            List<E> copy = new ArrayList<>(deque.size());
            deque.descendingIterator().forEachRemaining(copy::add);
            return new CopyIterator<>(copy, this::removeLastIdentical);
        }
    }

    private void removeLastIdentical(E element) {
        synchronized (guard) {
            Iterator<E> elements = deque.descendingIterator();
            while (elements.hasNext()) {
                if (elements.next() == element) {
                    elements.remove();
                    guard.notifyAll();
                    return;
                }
            }
        }
    }
}
