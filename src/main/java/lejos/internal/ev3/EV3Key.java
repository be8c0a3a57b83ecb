package lejos.internal.ev3;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lejos.hardware.Key;
import lejos.hardware.KeyListener;
import lejos.utility.Delay;

/** One key of the brick. */
public class EV3Key implements Key {
    private static final List<String> NAMES = List.of("Up", "Enter", "Down", "Right", "Left", "Escape");
    private static final int SIMULATED_PRESS_MILLIS = 100;
    private static final int RELEASED_SHIFT = 8;

    private final EV3Keys keys;
    private final String name;
    private final int id;
    private final List<KeyListener> listeners = new CopyOnWriteArrayList<>();

    /** The key of that name. */
    public EV3Key(EV3Keys keys, String name) {
        this.keys = keys;
        this.name = name;
        this.id = getKeyId(name);
    }

    @Override
    public int getId() {
        return id;
    }

    @Override
    public boolean isDown() {
        return (keys.readButtons(id) & id) != 0;
    }

    @Override
    public boolean isUp() {
        return !isDown();
    }

    @Override
    public void waitForPress() {
        boolean pressed = false;
        while (!pressed && !Thread.currentThread().isInterrupted()) {
            pressed = (keys.waitForAnyPress() & id) != 0;
        }
    }

    @Override
    public void waitForPressAndRelease() {
        waitForPress();
        boolean released = false;
        while (!released && !Thread.currentThread().isInterrupted()) {
            released = (keys.waitForAnyEvent() & id << RELEASED_SHIFT) != 0;
        }
    }

    @Override
    public void addKeyListener(KeyListener listener) {
        listeners.add(listener);
        keys.dispatchTo(this);
    }

    @Override
    public void simulateEvent(int event) {
        if (event == KEY_PRESSED || event == KEY_PRESSED_AND_RELEASED) {
            keys.setSimultedState(keys.getSimulatedState() | id);
        }
        if (event == KEY_PRESSED_AND_RELEASED) {
            Delay.msDelay(SIMULATED_PRESS_MILLIS);
        }
        if (event == KEY_RELEASED || event == KEY_PRESSED_AND_RELEASED) {
            keys.setSimultedState(keys.getSimulatedState() & ~id);
        }
    }

    /** Tells all listeners what the key is doing at this moment. */
    public void callListeners() {
        boolean down = isDown();
        for (KeyListener listener : listeners) {
            if (down) {
                listener.keyPressed(this);
            } else {
                listener.keyReleased(this);
            }
        }
    }

    /** Position of the key of that name, −1 if there is none. */
    public static int getKeyPos(String name) {
        return NAMES.indexOf(name);
    }

    /**
     * Bit of the key of that name.
     *
     * @throws IllegalArgumentException if there is no such key
     */
    public static int getKeyId(String name) {
        int position = getKeyPos(name);
        if (position < 0) {
            throw new IllegalArgumentException("no key named " + name);
        }
        return 1 << position;
    }

    @Override
    public String getName() {
        return name;
    }
}
