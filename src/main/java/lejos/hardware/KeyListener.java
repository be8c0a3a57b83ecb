package lejos.hardware;

/** Hears about one key. All listeners of all keys are called on one thread, one after the other. */
public interface KeyListener {
    /** The key went down. */
    void keyPressed(Key k);

    /** The key went up. */
    void keyReleased(Key k);
}
