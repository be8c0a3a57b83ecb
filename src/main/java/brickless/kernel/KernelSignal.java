package brickless.kernel;

/** A signal that the fibres of one kernel wait for. */
final class KernelSignal implements Processor.Signal {
    private final Scheduler scheduler;
    private final FibreQueue waiters = new FibreQueue();

    KernelSignal(Scheduler scheduler) {
        this.scheduler = scheduler;
    }

    @Override
    public void raise() {
        for (Fibre fibre = waiters.poll(); fibre != null; fibre = waiters.poll()) {
            scheduler.wake(fibre, Wake.RESUMED);
        }
    }

    @Override
    public boolean await(long timeoutNanos) {
        return block(FibreState.SIGNAL, timeoutNanos) == Wake.RESUMED;
    }

    @Override
    public boolean awaitInterruptibly(long timeoutNanos) throws InterruptedException {
        Fibre me = scheduler.current();
        if (me.takeInterrupt()) {
            throw new InterruptedException();
        }
        Wake reason = block(FibreState.SIGNAL_INTERRUPTIBLY, timeoutNanos);
        if (reason == Wake.INTERRUPTED && me.takeInterrupt()) {
            throw new InterruptedException();
        }
        return reason == Wake.RESUMED;
    }

    private Wake block(FibreState state, long timeoutNanos) {
        if (timeoutNanos < 0) {
            throw new IllegalArgumentException("negative timeout: " + timeoutNanos + " ns");
        }
        scheduler.enter();
        waiters.addLast(scheduler.current());
        return scheduler.block(state, timeoutNanos);
    }
}
