package brickless.kernel;

/** A fingerprint of everything that a kernel's schedule shows. */
final class ScheduleHash implements KernelListener {
    private long hash = 1;
    private int events;

    static ScheduleHash of(Kernel kernel) {
        ScheduleHash hash = new ScheduleHash();
        kernel.listen(hash);
        return hash;
    }

    int events() {
        return events;
    }

    @Override
    public void scheduled(long timeNanos, int fibre) {
        add(timeNanos, fibre);
    }

    @Override
    public void started(long timeNanos, Thread thread) {
        add(timeNanos, thread.getName().hashCode());
    }

    @Override
    public void ended(long timeNanos, Thread thread) {
        add(timeNanos, ~thread.getName().hashCode());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ScheduleHash that && that.hash == hash && that.events == events;
    }

    @Override
    public int hashCode() {
        return Long.hashCode(hash);
    }

    @Override
    public String toString() {
        return Long.toHexString(hash) + " of " + events;
    }

    private void add(long time, long value) {
        hash = (hash * 1_000_003 + time) * 1_000_003 + value;
        events++;
    }
}
