package lejos.robotics.objectdetection;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lejos.utility.Delay;

/**
 * A detector that scans on a daemon thread of its own and tells its listeners what it finds.
 *
 * <p>The thread starts with the first listener, when the object is complete for sure.
 */
public abstract class FeatureDetectorAdapter implements FeatureDetector {
    private final List<FeatureListener> listeners = new CopyOnWriteArrayList<>();
    private volatile boolean enabled = true;
    private volatile int delay;
    private boolean watching;

    /** A detector that looks once per so many milliseconds, enabled. */
    public FeatureDetectorAdapter(int delay) {
        this.delay = delay;
    }

    @Override
    public void addListener(FeatureListener listener) {
        listeners.add(listener);
        startWatch();
    }

    @Override
    public void enableDetection(boolean enable) {
        enabled = enable;
    }

    @Override
    public boolean isEnabled() {
        return enabled;
    }

    @Override
    public int getDelay() {
        return delay;
    }

    @Override
    public void setDelay(int delay) {
        this.delay = delay;
    }

    /** Tells the listeners, in the order they were added. */
    protected void notifyListeners(Feature feature) {
        for (FeatureListener listener : listeners) {
            listener.featureDetected(feature, this);
        }
    }

    @Override
    public abstract Feature scan();

    private synchronized void startWatch() {
        if (!watching) {
            watching = true;
            Thread watch = new Thread(this::watch);
            watch.setDaemon(true);
            watch.start();
        }
    }

    private void watch() {
        while (true) {
            long begun = System.currentTimeMillis();
            if (enabled) {
                Feature feature = scan();
                if (feature != null) {
                    notifyListeners(feature);
                }
            }
            Delay.msDelay(Math.max(1, begun + delay - System.currentTimeMillis()));
        }
    }
}
