package lejos.hardware;

/** One key of the brick. */
public interface Key {
    /** Position of the UP key. Positions are not ids. */
    int UP = 0;
    /** Position of the ENTER key. */
    int ENTER = 1;
    /** Position of the DOWN key. */
    int DOWN = 2;
    /** Position of the RIGHT key. */
    int RIGHT = 3;
    /** Position of the LEFT key. */
    int LEFT = 4;
    /** Position of the ESCAPE key. */
    int ESCAPE = 5;
    /** Event: the key goes up. */
    int KEY_RELEASED = 0;
    /** Event: the key goes down. */
    int KEY_PRESSED = 1;
    /** Event: the key goes down and up again. */
    int KEY_PRESSED_AND_RELEASED = 2;

    /** The key's bit in masks: 1, 2, 4, 8, 16 or 32. */
    int getId();

    /** Whether the key is down; takes about 60 ms, with a click, when a key has gone down since the last look. */
    boolean isDown();

    /** Whether the key is up; takes about 60 ms, with a click, when a key has gone down since the last look. */
    boolean isUp();

    /**
     * Blocks until the key goes down; presses of other keys are used up. Returns early if the thread is interrupted.
     */
    void waitForPress();

    /**
     * Blocks until the key goes down and up again; events of other keys are used up. Returns early if the thread is
     * interrupted.
     */
    void waitForPressAndRelease();

    /** Adds a listener for this key; it cannot be removed. */
    void addKeyListener(KeyListener listener);

    /**
     * Acts as if the key were moved.
     *
     * @param event {@link #KEY_PRESSED}, {@link #KEY_RELEASED}, or {@link #KEY_PRESSED_AND_RELEASED}, which holds the
     *     key for 100 ms and blocks meanwhile
     */
    void simulateEvent(int event);

    /** Name of the key: {@code Up}, {@code Enter}, {@code Down}, {@code Right}, {@code Left} or {@code Escape}. */
    String getName();
}
