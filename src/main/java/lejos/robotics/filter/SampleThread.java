package lejos.robotics.filter;

import lejos.robotics.SampleProvider;

/**
 * Takes samples at a regular rate on a thread of its own; a fetch returns the newest of them at once.
 *
 * <p>The thread is a daemon and starts with the constructor. May be used by any thread; this object's lock guards the
 * newest sample.
 */
public class SampleThread extends AbstractFilter {
    private static final float MILLIS_PER_SECOND = 1000;

    private final float[] newest;
    private float sampleRate;
    private boolean sampling = true;
    private boolean fresh;

    /**
     * Starts sampling.
     *
     * @param source where samples come from
     * @param sampleRate samples per second
     */
    public SampleThread(SampleProvider source, float sampleRate) {
        super(source);
        this.newest = new float[sampleSize];
        this.sampleRate = sampleRate;
        Thread sampler = new Thread(this::sample);
        sampler.setDaemon(true);
        sampler.start();
    }

    /** Whether a sample was taken since the last fetch. */
    public synchronized boolean isNewSampleAvailable() {
        return fresh;
    }

    /** Copies the newest sample; zeros before the first. */
    @Override
    public synchronized void fetchSample(float[] sample, int offset) {
        System.arraycopy(newest, 0, sample, offset, sampleSize);
        fresh = false;
    }

    /** Samples per second. */
    public synchronized float getSampleRate() {
        return sampleRate;
    }

    /** Sets the samples per second, from the next sample on. */
    public synchronized void setSampleRate(float sampleRate) {
        this.sampleRate = sampleRate;
    }

    /** Goes on sampling after {@link #stop}. */
    public synchronized void start() {
        sampling = true;
        notifyAll();
    }

    /** Stops sampling until {@link #start}. */
    public synchronized void stop() {
        sampling = false;
    }

    private void sample() {
        float[] sample = new float[sampleSize];
        long due = System.currentTimeMillis();
        try {
            while (true) {
                awaitStarted();
                source.fetchSample(sample, 0);
                publish(sample);
                long now = System.currentTimeMillis();
                due = Math.max(due + period(), now);
                Thread.sleep(due - now);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void awaitStarted() throws InterruptedException {
        while (!sampling) {
            wait();
        }
    }

    private synchronized void publish(float[] sample) {
        System.arraycopy(sample, 0, newest, 0, sampleSize);
        fresh = true;
    }

    private synchronized long period() {
        return (long) (MILLIS_PER_SECOND / sampleRate);
    }
}
