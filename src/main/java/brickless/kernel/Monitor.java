package brickless.kernel;

/** The virtual monitor of one object; exists only while somebody owns it, wants it or waits in it. */
final class Monitor {
    Object lock;
    Fibre owner;
    /** How often the owner entered. */
    int count;
    /** Fibres that want the monitor and sleep. */
    final FibreQueue entrants = new FibreQueue();
    /** Fibres in {@code Object.wait}. */
    final FibreQueue waiters = new FibreQueue();
    /** The entrant that was woken at the last exit and has not run yet. */
    Fibre woken;
    /** Fibres inside enter or wait, which hold a reference to this monitor. */
    int users;
    /** Next in the free list of {@link MonitorTable}. */
    Monitor nextFree;

    boolean idle() {
        return owner == null && users == 0;
    }
}
