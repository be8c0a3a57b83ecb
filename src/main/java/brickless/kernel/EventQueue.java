package brickless.kernel;

import java.util.Arrays;

/**
 * Events by time, those of one time in order of insertion: a binary heap whose events know their place, so that
 * removal is fast too.
 */
final class EventQueue {
    private Event[] heap = new Event[16];
    private int size;
    private long sequence;
    /** Of the first event; kept here because every robot is asked at every step, with its heap in no cache. */
    private long nextTimeNanos = Long.MAX_VALUE;

    /** Time of the first event, {@code Long.MAX_VALUE} if there is none. */
    long nextTimeNanos() {
        return nextTimeNanos;
    }

    int size() {
        return size;
    }

    void add(Event event, long timeNanos) {
        if (event.queued()) {
            throw new IllegalStateException("event is queued already");
        }
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, 2 * size);
        }
        event.timeNanos = timeNanos;
        event.sequence = sequence++;
        siftUp(event, size++);
        noteNextTime();
    }

    /** Removes and returns the first event; the queue must not be empty. */
    Event poll() {
        Event first = heap[0];
        remove(first);
        return first;
    }

    /** Removes an event; nothing happens if it is not queued. */
    void remove(Event event) {
        int hole = event.index;
        if (hole < 0) {
            return;
        }
        event.index = -1;
        Event last = heap[--size];
        heap[size] = null;
        if (last != event) {
            siftDown(last, hole);
            if (last.index == hole) {
                siftUp(last, hole);
            }
        }
        noteNextTime();
    }

    void clear() {
        for (int i = 0; i < size; i++) {
            heap[i].index = -1;
            heap[i] = null;
        }
        size = 0;
        noteNextTime();
    }

    private void noteNextTime() {
        nextTimeNanos = size == 0 ? Long.MAX_VALUE : heap[0].timeNanos;
    }

    private void siftUp(Event event, int from) {
        int hole = from;
        while (hole > 0) {
            int parent = (hole - 1) >>> 1;
            if (!event.before(heap[parent])) {
                break;
            }
            place(heap[parent], hole);
            hole = parent;
        }
        place(event, hole);
    }

    private void siftDown(Event event, int from) {
        int hole = from;
        while (2 * hole + 1 < size) {
            int child = 2 * hole + 1;
            if (child + 1 < size && heap[child + 1].before(heap[child])) {
                child++;
            }
            if (!heap[child].before(event)) {
                break;
            }
            place(heap[child], hole);
            hole = child;
        }
        place(event, hole);
    }

    private void place(Event event, int index) {
        heap[index] = event;
        event.index = index;
    }
}
