package brickless.kernel;

/**
 * Monitors by the identity of their objects: open addressing with linear probing.
 *
 * <p>Identity hash codes, which come from the host, decide only where an entry lies, and nothing iterates over the
 * entries. Idle monitors are taken out at once, so no object is kept alive, and used again for other objects, so the
 * usual enter allocates nothing.
 */
final class MonitorTable {
    private static final int FIRST_CAPACITY = 64;

    private Monitor[] slots = new Monitor[FIRST_CAPACITY];
    private int size;
    private Monitor free;

    /** The monitor of an object, or null if it is idle. */
    Monitor find(Object lock) {
        int mask = slots.length - 1;
        for (int i = home(lock, mask); slots[i] != null; i = i + 1 & mask) {
            if (slots[i].lock == lock) {
                return slots[i];
            }
        }
        return null;
    }

    /** The monitor of an object, a new one if it is idle. */
    Monitor findOrAdd(Object lock) {
        int mask = slots.length - 1;
        int i = home(lock, mask);
        while (slots[i] != null) {
            if (slots[i].lock == lock) {
                return slots[i];
            }
            i = i + 1 & mask;
        }
        Monitor monitor = take();
        monitor.lock = lock;
        slots[i] = monitor;
        if (2 * ++size > slots.length) {
            grow();
        }
        return monitor;
    }

    /** Takes out an idle monitor. */
    void remove(Monitor monitor) {
        int mask = slots.length - 1;
        int hole = home(monitor.lock, mask);
        while (slots[hole] != monitor) {
            hole = hole + 1 & mask;
        }
        closeGap(hole, mask);
        size--;
        monitor.lock = null;
        monitor.nextFree = free;
        free = monitor;
    }

    int size() {
        return size;
    }

    void clear() {
        slots = new Monitor[FIRST_CAPACITY];
        size = 0;
        free = null;
    }

    private Monitor take() {
        Monitor monitor = free;
        if (monitor == null) {
            return new Monitor();
        }
        free = monitor.nextFree;
        monitor.nextFree = null;
        return monitor;
    }

    /** Moves later entries of the same run back, so that no probe ends too early at the gap. */
    private void closeGap(int gap, int mask) {
        int hole = gap;
        for (int i = hole + 1 & mask; slots[i] != null; i = i + 1 & mask) {
            int distance = i - home(slots[i].lock, mask) & mask;
            if (distance >= (i - hole & mask)) {
                slots[hole] = slots[i];
                hole = i;
            }
        }
        slots[hole] = null;
    }

    private void grow() {
        Monitor[] old = slots;
        slots = new Monitor[2 * old.length];
        int mask = slots.length - 1;
        for (Monitor monitor : old) {
            if (monitor != null) {
                int i = home(monitor.lock, mask);
                while (slots[i] != null) {
                    i = i + 1 & mask;
                }
                slots[i] = monitor;
            }
        }
    }

    private static int home(Object lock, int mask) {
        int hash = System.identityHashCode(lock);
        return (hash ^ hash >>> 15) & mask;
    }
}
