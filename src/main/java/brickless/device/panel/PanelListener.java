package brickless.device.panel;

/**
 * Hears what happens at the brick's front, for the trace and the viewer. Called at the moment of the event on whatever
 * thread caused it; implementations must not block and not call the panel. Times are nanoseconds since the program's
 * start.
 */
public interface PanelListener {
    /** A listener that ignores everything. */
    PanelListener NONE = new PanelListener() {};

    /** Who moved a key. */
    enum KeyOrigin {
        /** A stimulus: the hand of a person or a test. */
        HAND,
        /** The automatic presses of {@link ButtonPolicy}. */
        POLICY,
        /** The program itself, by {@code Key.simulateEvent}. */
        PROGRAM
    }

    /**
     * Keys went down or up.
     *
     * @param keyMask the keys that changed, bits as in {@code KeySocket}
     */
    default void keysChanged(long nowNanos, int keyMask, boolean down, KeyOrigin origin) {}

    /** The LED pattern changed to {@code pattern}, 0 (off) to 9. */
    default void ledChanged(long nowNanos, int pattern) {}

    /** A tone started; volume in percent of the loudspeaker's maximum. */
    default void toneStarted(long nowNanos, int frequencyHertz, int durationMillis, int volumePercent) {}

    /** A recorded sound started; volume in percent of the loudspeaker's maximum. */
    default void sampleStarted(long nowNanos, String name, int durationMillis, int volumePercent) {}

    /** The loudspeaker was silenced while something was playing. */
    default void soundStopped(long nowNanos) {}

    /** The picture on the screen changed. */
    default void screenChanged(long nowNanos) {}
}
