package brickless.concurrent.locks;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Threads that wait for a resource, longest waiting first; the monitor of the line guards the resource too.
 *
 * <p>A fair line is strictly first come, first served. In one that is not, a newcomer may overtake, but only until the
 * first in line has been woken once in vain: so a loop that releases and takes again at once cannot starve the others,
 * however regular the schedule is.
 *
 * <p>Whoever makes the resource available calls {@link #changed()}. All methods may be called with or without the
 * monitor held.
 */
public final class WaitingLine {
    private final boolean fair;
    private final Deque<Place> places = new ArrayDeque<>();

    /** One waiting thread; guarded by the line's monitor. */
    private static final class Place {
        final Thread thread = Thread.currentThread();
        boolean tried;
        boolean overtaken;
    }

    /** Creates an empty line; {@code fair} forbids overtaking altogether. */
    public WaitingLine(boolean fair) {
        this.fair = fair;
    }

    /** Whether overtaking is forbidden. */
    public boolean isFair() {
        return fair;
    }

    /**
     * Waits for its turn and until {@code attempt}, which is called with the monitor held, takes the resource.
     *
     * @return false if the deadline passed first
     * @throws InterruptedException if the thread was interrupted before or while it waited
     */
    public boolean pass(BooleanSupplier attempt, Deadline deadline) throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
        synchronized (this) {
            return mayOvertake() && attempt.getAsBoolean() || queue(attempt, deadline);
        }
    }

    /** Waits like {@link #pass} for ever; an interrupt is kept for later. */
    public synchronized void passUninterruptibly(BooleanSupplier attempt) {
        if (mayOvertake() && attempt.getAsBoolean()) {
            return;
        }
        boolean interrupted = false;
        Place place = enqueue();
        try {
            while (!reached(place, attempt)) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } finally {
            leave(place);
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Lets the waiting threads try again. */
    public synchronized void changed() {
        notifyAll();
    }

    /** Number of waiting threads. */
    public synchronized int length() {
        return places.size();
    }

    /** The waiting threads, longest waiting first. */
    public synchronized List<Thread> threads() {
        List<Thread> threads = new ArrayList<>();
        for (Place place : places) {
            threads.add(place.thread);
        }
        return threads;
    }

    private boolean mayOvertake() {
        Place first = places.peekFirst();
        return first == null || !fair && !first.overtaken;
    }

    private boolean queue(BooleanSupplier attempt, Deadline deadline) throws InterruptedException {
        Place place = enqueue();
        try {
            boolean reached = reached(place, attempt);
            while (!reached && deadline.await(this)) {
                reached = reached(place, attempt);
            }
            return reached;
        } finally {
            leave(place);
        }
    }

    private Place enqueue() {
        Place place = new Place();
        places.addLast(place);
        return place;
    }

    private boolean reached(Place place, BooleanSupplier attempt) {
        if (places.peekFirst() != place) {
            return false;
        }
        if (attempt.getAsBoolean()) {
            return true;
        }
        place.overtaken = place.tried;
        place.tried = true;
        return false;
    }

    /**
     * The next in line may find enough left for itself, or may have been waiting only for this place to become free.
     */
    private void leave(Place place) {
        places.remove(place);
        if (!places.isEmpty()) {
            notifyAll();
        }
    }
}
