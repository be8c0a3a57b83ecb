package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.AbstractQueue;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.SynchronousQueue} on virtual monitors; always empty as seen from outside. */
public class SynchronousQueue<E> extends AbstractQueue<E> implements BlockingQueue<E> {
    private final HandOff<E> handOff;

    /** Creates a queue that serves the thread that came last first. */
    public SynchronousQueue() {
        this(false);
    }

    /** Creates a queue; a fair one serves threads in order of arrival. */
    public SynchronousQueue(boolean fair) {
        handOff = new HandOff<>(fair);
    }

    @Override
    public void put(E e) throws InterruptedException {
        give(e, Deadline.NEVER);
    }

    @Override
    public boolean offer(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return give(e, Deadline.after(timeout, unit));
    }

    private boolean give(E e, Deadline deadline) throws InterruptedException {
        Objects.requireNonNull(e);
        GuardedQueue.failIfInterrupted();
        return handOff.give(e, deadline);
    }

    @Override
    public boolean offer(E e) {
        return handOff.giveNow(Objects.requireNonNull(e));
    }

    @Override
    public E take() throws InterruptedException {
        GuardedQueue.failIfInterrupted();
        return handOff.take(Deadline.NEVER);
    }

    @Override
    public E poll(long timeout, TimeUnit unit) throws InterruptedException {
        GuardedQueue.failIfInterrupted();
        return handOff.take(Deadline.after(timeout, unit));
    }

    @Override
    public E poll() {
        return handOff.takeNow();
    }

    @Override
    public E peek() {
        return null;
    }

    @Override
    public int size() {
        return 0;
    }

    @Override
    public int remainingCapacity() {
        return 0;
    }

    @Override
    public void clear() {
    }

    @Override
    public Iterator<E> iterator() {
        return Collections.emptyIterator();
    }

    @Override
    public int drainTo(Collection<? super E> target) {
        return drainTo(target, Integer.MAX_VALUE);
    }

    @Override
    public int drainTo(Collection<? super E> target, int maxElements) {
        return LinkedTransferQueue.drain(this, target, maxElements);
    }
}
