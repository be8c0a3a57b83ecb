package lejos.robotics.objectdetection;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lejos.robotics.RangeReadings;
import lejos.utility.Delay;

/**
 * Several detectors as one: collects what they find and tells its listeners of all of it together.
 *
 * <p>A daemon thread, started with the first detector, tells once per delay. Detectors call from threads of their own;
 * this object's lock guards what was collected.
 */
public class FusorDetector implements FeatureDetector, FeatureListener {
    private final List<FeatureDetector> detectors = new CopyOnWriteArrayList<>();
    private final List<FeatureListener> listeners = new CopyOnWriteArrayList<>();
    private RangeReadings collected = new RangeReadings(0);
    private volatile boolean enabled = true;
    private volatile int delay;

    /** A detector that finds nothing until others are added. */
    public FusorDetector() {
    }

    /** Adds a detector; the delay becomes the longest of all. */
    public void addDetector(FeatureDetector detector) {
        detector.addListener(this);
        delay = Math.max(delay, detector.getDelay());
        detectors.add(detector);
        if (detectors.size() == 1) {
            Thread notifier = new Thread(this::tell);
            notifier.setDaemon(true);
            notifier.start();
        }
    }

    /** Lets all detectors look once; null if none finds anything. */
    @Override
    public Feature scan() {
        RangeReadings readings = new RangeReadings(0);
        for (FeatureDetector detector : detectors) {
            Feature feature = detector.scan();
            if (feature != null) {
                readings.addAll(feature.getRangeReadings());
            }
        }
        return readings.isEmpty() ? null : new RangeFeature(readings);
    }

    /** Collects what one of the detectors found. */
    @Override
    public synchronized void featureDetected(Feature feature, FeatureDetector detector) {
        collected.addAll(feature.getRangeReadings());
    }

    @Override
    public void addListener(FeatureListener listener) {
        listeners.add(listener);
    }

    /** Turns the watch of all detectors on or off. */
    @Override
    public void enableDetection(boolean enable) {
        enabled = enable;
        for (FeatureDetector detector : detectors) {
            detector.enableDetection(enable);
        }
    }

    @Override
    public int getDelay() {
        return delay;
    }

    @Override
    public boolean isEnabled() {
        return enabled;
    }

    @Override
    public void setDelay(int delay) {
        this.delay = delay;
    }

    private void tell() {
        while (true) {
            Delay.msDelay(Math.max(1, delay));
            RangeReadings readings = takeCollected();
            if (!readings.isEmpty()) {
                Feature feature = new RangeFeature(readings);
                listeners.forEach(listener -> listener.featureDetected(feature, this));
            }
        }
    }

    private synchronized RangeReadings takeCollected() {
        RangeReadings taken = collected;
        collected = new RangeReadings(0);
        return taken;
    }
}
