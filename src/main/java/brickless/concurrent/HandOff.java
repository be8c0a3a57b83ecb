package brickless.concurrent;

import brickless.concurrent.locks.Deadline;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.function.Predicate;

/**
 * Where givers and takers of elements meet; at any moment at most one kind waits. An element may also be left behind by
 * a giver that does not wait. Guarded by its own monitor.
 */
final class HandOff<E> {
    private final boolean firstComeFirstServed;
    private final Deque<Party<E>> givers = new ArrayDeque<>();
    private final Deque<Party<E>> takers = new ArrayDeque<>();

    /** One who waits, or an element left behind. */
    private static final class Party<E> {
        E element;
        boolean served;

        Party(E element) {
            this.element = element;
        }
    }

    /** Creates a meeting place; without {@code firstComeFirstServed} the party that came last is served first. */
    HandOff(boolean firstComeFirstServed) {
        this.firstComeFirstServed = firstComeFirstServed;
    }

    /** Hands the element to a taker that waits already; false if there is none. */
    synchronized boolean giveNow(E element) {
        Party<E> taker = takers.pollFirst();
        if (taker == null) {
            return false;
        }
        taker.element = element;
        serve(taker);
        return true;
    }

    /** Hands the element over now or leaves it for a taker to come. */
    synchronized void leave(E element) {
        if (!giveNow(element)) {
            enqueue(givers, new Party<>(element));
        }
    }

    /** Hands the element over, waiting for a taker; false if the deadline passed first. */
    synchronized boolean give(E element, Deadline deadline) throws InterruptedException {
        return giveNow(element) || awaitService(givers, new Party<>(element), deadline);
    }

    /** Takes an element that is offered already; null if there is none. */
    synchronized E takeNow() {
        Party<E> giver = givers.pollFirst();
        if (giver == null) {
            return null;
        }
        serve(giver);
        return giver.element;
    }

    /** Takes an element, waiting for one; null if the deadline passed first. */
    synchronized E take(Deadline deadline) throws InterruptedException {
        E element = takeNow();
        if (element != null) {
            return element;
        }
        Party<E> taker = new Party<>(null);
        return awaitService(takers, taker, deadline) ? taker.element : null;
    }

    synchronized int waitingTakers() {
        return takers.size();
    }

    /** The elements on offer, next one first. */
    synchronized List<E> offered() {
        List<E> elements = new ArrayList<>(givers.size());
        for (Party<E> giver : givers) {
            elements.add(giver.element);
        }
        return elements;
    }

    /** Removes the first element on offer that matches, as if a taker had come for it. */
    synchronized boolean remove(Predicate<? super E> match) {
        for (Iterator<Party<E>> i = givers.iterator(); i.hasNext();) {
            Party<E> giver = i.next();
            if (match.test(giver.element)) {
                i.remove();
                serve(giver);
                return true;
            }
        }
        return false;
    }

    private void serve(Party<E> party) {
        party.served = true;
        notifyAll();
    }

    private void enqueue(Deque<Party<E>> parties, Party<E> party) {
        if (firstComeFirstServed) {
            parties.addLast(party);
        } else {
            parties.addFirst(party);
        }
    }

    private boolean awaitService(Deque<Party<E>> parties, Party<E> party, Deadline deadline)
            throws InterruptedException {
        enqueue(parties, party);
        try {
            while (!party.served && deadline.await(this)) {
                continue;
            }
        } catch (InterruptedException e) {
            if (!party.served) {
                throw e;
            }
            // Served first, interrupted second: the element must not be lost, the interrupt neither.
            Thread.currentThread().interrupt();
        } finally {
            parties.remove(party);
        }
        return party.served;
    }
}
