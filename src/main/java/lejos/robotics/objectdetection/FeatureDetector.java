package lejos.robotics.objectdetection;

/** Watches for objects. */
public interface FeatureDetector {
    /** Adds a listener. */
    void addListener(FeatureListener listener);

    /** Looks once; null if nothing is there. Works while detection is disabled, too. */
    Feature scan();

    /** Turns the watch on or off. */
    void enableDetection(boolean enable);

    /** Whether the watch is on. */
    boolean isEnabled();

    /** Time between two looks in milliseconds. */
    int getDelay();

    /** Sets the time between two looks in milliseconds. */
    void setDelay(int delay);
}
