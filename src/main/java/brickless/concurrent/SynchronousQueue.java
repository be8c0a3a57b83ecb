package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.Collections;
import java.util.Iterator;
import java.util.Objects;
import java.util.concurrent.TimeUnit;

/** {@code java.util.concurrent.SynchronousQueue} on virtual monitors; always empty as seen from outside. */
public class SynchronousQueue<E> extends HandOffQueue<E> {
    /** Creates a queue that serves the thread that came last first. */
    public SynchronousQueue() {
        this(false);
    }

    /** Creates a queue; a fair one serves threads in order of arrival. */
    public SynchronousQueue(boolean fair) {
        super(new HandOff<>(fair));
    }

    @Override
    public void put(E e) throws InterruptedException {
        give(e, Deadline.NEVER);
    }

    @Override
    public boolean offer(E e, long timeout, TimeUnit unit) throws InterruptedException {
        return give(e, Deadline.after(timeout, unit));
    }

    @Override
    public boolean offer(E e) {
        return handOff.giveNow(Objects.requireNonNull(e));
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
}
