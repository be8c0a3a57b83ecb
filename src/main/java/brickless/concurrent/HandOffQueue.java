package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.AbstractQueue;
import java.util.Collection;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;

/** A queue whose givers and takers meet at a {@link HandOff}. */
abstract class HandOffQueue<E> extends AbstractQueue<E> implements BlockingQueue<E> {
    final HandOff<E> handOff;

    HandOffQueue(HandOff<E> handOff) {
        this.handOff = handOff;
    }

    /** Waits until a taker has the element; false if none came in time. */
    final boolean give(E e, Deadline deadline) throws InterruptedException {
        Objects.requireNonNull(e);
        GuardedQueue.failIfInterrupted();
        return handOff.give(e, deadline);
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
    public int drainTo(Collection<? super E> target) {
        return drainTo(target, Integer.MAX_VALUE);
    }

    @Override
    public int drainTo(Collection<? super E> target, int maxElements) {
        Objects.requireNonNull(target);
        if (target == this) {
            throw new IllegalArgumentException("a queue cannot drain to itself");
        }
        int drained = 0;
        while (drained < maxElements) {
            E element = poll();
            if (element == null) {
                break;
            }
            target.add(element);
            drained++;
        }
        return drained;
    }
}
