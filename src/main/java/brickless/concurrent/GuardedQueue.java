package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.AbstractQueue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Queue;
import java.util.Spliterator;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * A JDK queue behind one monitor, with a capacity and, for delay queues, heads that are not ready yet. Threads blocked
 * on it are woken in the order in which they came; iterators walk over a copy, which is what "weakly consistent"
 * permits.
 */
abstract class GuardedQueue<E> extends AbstractQueue<E> implements BlockingQueue<E> {
    /** Guards the store. */
    final Object guard = new Object();
    private final Queue<E> store;
    private final int capacity;

    GuardedQueue(Queue<E> store, int capacity) {
        this.store = store;
        this.capacity = capacity;
    }

    /** Nanoseconds until that head of the queue may be taken; zero or less means now. */
    long nanosUntilReady(E head) {
        return 0;
    }

    /** Waits, with the guard held, until there is room; false if the deadline passed first. */
    final boolean awaitRoom(Deadline deadline) throws InterruptedException {
        while (store.size() >= capacity) {
            if (!deadline.await(guard)) {
                return false;
            }
        }
        return true;
    }

    /** Waits, with the guard held, until the head may be taken; false if the deadline passed first. */
    final boolean awaitReady(Deadline deadline) throws InterruptedException {
        while (!ready()) {
            if (deadline.passed()) {
                return false;
            }
            E head = store.peek();
            Deadline next = head == null ? deadline : deadline.orAfter(nanosUntilReady(head));
            next.await(guard);
        }
        return true;
    }

    final boolean hasRoom() {
        return store.size() < capacity;
    }

    private boolean ready() {
        E head = store.peek();
        return head != null && nanosUntilReady(head) <= 0;
    }

    static void failIfInterrupted() throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }

    @Override
    public boolean offer(E e) {
        Objects.requireNonNull(e);
        synchronized (guard) {
            if (!hasRoom()) {
                return false;
            }
            store.add(e);
            guard.notifyAll();
            return true;
        }
    }

    @Override
    public void put(E e) throws InterruptedException {
        insert(e, Deadline.NEVER);
    }

    @Override
    public boolean offer(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return insert(e, Deadline.after(timeout, unit));
    }

    private boolean insert(E e, Deadline deadline) throws InterruptedException {
        Objects.requireNonNull(e);
        failIfInterrupted();
        synchronized (guard) {
            return awaitRoom(deadline) && offer(e);
        }
    }

    @Override
    public E take() throws InterruptedException {
        return remove(Deadline.NEVER);
    }

    @Override
    public E poll(long timeout, TimeUnit unit) throws InterruptedException {
        return remove(Deadline.after(timeout, unit));
    }

    private E remove(Deadline deadline) throws InterruptedException {
        failIfInterrupted();
        synchronized (guard) {
            return awaitReady(deadline) ? poll() : null;
        }
    }

    @Override
    public E poll() {
        synchronized (guard) {
            if (!ready()) {
                return null;
            }
            E head = store.poll();
            guard.notifyAll();
            return head;
        }
    }

    @Override
    public E peek() {
        synchronized (guard) {
            return store.peek();
        }
    }

    @Override
    public int size() {
        synchronized (guard) {
            return store.size();
        }
    }

    @Override
    public int remainingCapacity() {
        return capacity - size();
    }

    @Override
    public boolean contains(Object o) {
        synchronized (guard) {
            return store.contains(o);
        }
    }

    @Override
    public boolean remove(Object o) {
        synchronized (guard) {
            boolean removed = store.remove(o);
            guard.notifyAll();
            return removed;
        }
    }

    @Override
    public boolean removeIf(Predicate<? super E> filter) {
        synchronized (guard) {
            boolean removed = store.removeIf(filter);
            guard.notifyAll();
            return removed;
        }
    }

    @Override
    public void clear() {
        synchronized (guard) {
            store.clear();
            guard.notifyAll();
        }
    }

    @Override
    public Object[] toArray() {
        synchronized (guard) {
            return store.toArray();
        }
    }

    @Override
    public <T> T[] toArray(T[] array) {
        synchronized (guard) {
            return store.toArray(array);
        }
    }

    @Override
    public int drainTo(Collection<? super E> target) {
        return drainTo(target, Integer.MAX_VALUE);
    }

    @Override
    public int drainTo(Collection<? super E> target, int maxElements) {
        Objects.requireNonNull(target);
        if (target == this) {
            throw new IllegalArgumentException("a queue cannot drain to itself");
        }
        synchronized (guard) {
            int drained = 0;
            while (drained < maxElements && ready()) {
                target.add(store.peek());
                store.poll();
                drained++;
            }
            guard.notifyAll();
            return drained;
        }
    }

    @Override
    public Iterator<E> iterator() {
        synchronized (guard) {
            return new CopyIterator<>(new ArrayList<>(store), this::removeIdentical);
        }
    }

    /** A late-binding spliterator would need a size that cannot change. */
    @Override
    @SuppressWarnings("unchecked")
    public Spliterator<E> spliterator() {
        return ((List<E>) Arrays.asList(toArray())).spliterator();
    }

    private void removeIdentical(E element) {
        synchronized (guard) {
            Iterator<E> elements = store.iterator();
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
