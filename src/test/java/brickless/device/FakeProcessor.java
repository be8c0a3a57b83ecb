package brickless.device;

import brickless.kernel.Processor;
import java.util.function.LongConsumer;

/** A processor for tests with one thread: charging and waiting run the physics steps that are due. */
public final class FakeProcessor implements Processor {
    private final long stepNanos;
    private final LongConsumer step;
    private long now;
    private long stepped;

    /** Calls {@code step} with the start time of each step that is due. */
    public FakeProcessor(long stepNanos, LongConsumer step) {
        this.stepNanos = stepNanos;
        this.step = step;
    }

    @Override
    public long nowNanos() {
        return now;
    }

    @Override
    public void charge(long nanos) {
        now += nanos;
        while (stepped + stepNanos <= now) {
            step.accept(stepped);
            stepped += stepNanos;
        }
    }

    /** Lets time pass. */
    public void runMillis(long millis) {
        charge(millis * 1_000_000);
    }

    @Override
    public Signal newSignal() {
        return new FakeSignal();
    }

    private final class FakeSignal implements Signal {
        private boolean raised;

        @Override
        public void raise() {
            raised = true;
        }

        @Override
        public boolean await(long timeoutNanos) {
            raised = false;
            long end = timeoutNanos == 0 ? Long.MAX_VALUE : now + timeoutNanos;
            while (!raised && now < end) {
                charge(Math.min(stepNanos, end - now));
            }
            return raised;
        }

        @Override
        public boolean awaitInterruptibly(long timeoutNanos) throws InterruptedException {
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
            return await(timeoutNanos);
        }
    }
}
