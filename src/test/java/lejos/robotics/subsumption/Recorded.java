package lejos.robotics.subsumption;

import java.util.concurrent.atomic.AtomicInteger;

/** A behaviour made by hand that counts its calls and lets a test wait for them. */
final class Recorded implements Behavior {
    private static final Runnable NOTHING = () -> { };

    volatile boolean wants;
    volatile Runnable act = NOTHING;
    volatile Runnable onAsked = NOTHING;
    volatile Runnable onSuppressed = NOTHING;
    final AtomicInteger asked = new AtomicInteger();
    final AtomicInteger acted = new AtomicInteger();
    final AtomicInteger suppressed = new AtomicInteger();

    @Override
    public boolean takeControl() {
        count(asked);
        onAsked.run();
        return wants;
    }

    @Override
    public void action() {
        count(acted);
        act.run();
    }

    @Override
    public void suppress() {
        count(suppressed);
        onSuppressed.run();
    }

    /** Waits for so many further questions. */
    void awaitAskedAgain(int times) {
        awaitCount(asked, asked.get() + times);
    }

    /** Waits until suppress was called so many times in all. */
    void awaitSuppressed(int times) {
        awaitCount(suppressed, times);
    }

    private synchronized void count(AtomicInteger counter) {
        counter.incrementAndGet();
        notifyAll();
    }

    private synchronized void awaitCount(AtomicInteger counter, int target) {
        while (counter.get() < target) {
            try {
                wait();
            } catch (InterruptedException e) {
                throw new AssertionError(e);
            }
        }
    }
}
