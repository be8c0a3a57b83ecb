package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Spliterator;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TransferQueue;

/** {@code java.util.concurrent.LinkedTransferQueue} on virtual monitors. */
public class LinkedTransferQueue<E> extends HandOffQueue<E> implements TransferQueue<E> {
    /** Creates an empty queue. */
    public LinkedTransferQueue() {
        super(new HandOff<>(true));
    }

    /** Creates a queue that holds the elements. */
    public LinkedTransferQueue(Collection<? extends E> c) {
        this();
        addAll(c);
    }

    @Override
    public boolean offer(E e) {
        handOff.leave(Objects.requireNonNull(e));
        return true;
    }

    /** Never blocks. */
    @Override
    public void put(E e) {
        offer(e);
    }

    /** Never blocks. */
    @Override
    public boolean offer(E e, long timeout, TimeUnit unit) {
        return offer(e);
    }

    @Override
    public boolean tryTransfer(E e) {
        return handOff.giveNow(Objects.requireNonNull(e));
    }

    @Override
    public void transfer(E e) throws InterruptedException {
        give(e, Deadline.NEVER);
    }

    @Override
    public boolean tryTransfer(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return give(e, Deadline.after(timeout, unit));
    }

    @Override
    public E peek() {
        List<E> offered = handOff.offered();
        return offered.isEmpty() ? null : offered.get(0);
    }

    @Override
    public int size() {
        return handOff.offered().size();
    }

    @Override
    public int remainingCapacity() {
        return Integer.MAX_VALUE;
    }

    @Override
    public boolean hasWaitingConsumer() {
        return handOff.waitingTakers() > 0;
    }

    @Override
    public int getWaitingConsumerCount() {
        return handOff.waitingTakers();
    }

    @Override
    public boolean contains(Object o) {
        return handOff.offered().contains(o);
    }

    @Override
    public boolean remove(Object o) {
        return o != null && handOff.remove(o::equals);
    }

    @Override
    public Iterator<E> iterator() {
        return new CopyIterator<>(handOff.offered(), element -> handOff.remove(offered -> offered == element));
    }

    @Override
    public Object[] toArray() {
        return handOff.offered().toArray();
    }

    @Override
    public <T> T[] toArray(T[] array) {
        return handOff.offered().toArray(array);
    }

    @Override
    public Spliterator<E> spliterator() {
        return handOff.offered().spliterator();
    }
}
