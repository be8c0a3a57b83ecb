package brickless.kernel;

/** Fibres in line, linked through themselves: a fibre is in one queue at most, and leaves it without a search. */
final class FibreQueue {
    private Fibre first;
    private Fibre last;
    private int size;

    boolean isEmpty() {
        return first == null;
    }

    int size() {
        return size;
    }

    void addLast(Fibre fibre) {
        link(last, fibre, null);
    }

    void addFirst(Fibre fibre) {
        link(null, fibre, first);
    }

    /** Removes and returns the first fibre, or null. */
    Fibre poll() {
        Fibre fibre = first;
        if (fibre != null) {
            remove(fibre);
        }
        return fibre;
    }

    /** Removes and returns the fibre at a place, 0 = first. */
    Fibre poll(int index) {
        Fibre fibre = first;
        for (int i = 0; i < index; i++) {
            fibre = fibre.next;
        }
        remove(fibre);
        return fibre;
    }

    void remove(Fibre fibre) {
        if (fibre.queue != this) {
            throw new IllegalStateException("fibre is in another queue");
        }
        if (fibre.previous == null) {
            first = fibre.next;
        } else {
            fibre.previous.next = fibre.next;
        }
        if (fibre.next == null) {
            last = fibre.previous;
        } else {
            fibre.next.previous = fibre.previous;
        }
        fibre.queue = null;
        fibre.previous = null;
        fibre.next = null;
        size--;
    }

    private void link(Fibre before, Fibre fibre, Fibre after) {
        if (fibre.queue != null) {
            throw new IllegalStateException("fibre is in a queue already");
        }
        fibre.queue = this;
        fibre.previous = before;
        fibre.next = after;
        if (before == null) {
            first = fibre;
        } else {
            before.next = fibre;
        }
        if (after == null) {
            last = fibre;
        } else {
            after.previous = fibre;
        }
        size++;
    }
}
