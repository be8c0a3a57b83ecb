package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.KeySocket;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.Audio;
import lejos.hardware.Keys;
import lejos.internal.io.SystemSettings;
import lejos.utility.Delay;

/**
 * The keys of the brick.
 *
 * <p>leJOS looks at the keys every 50 ms while it waits. This class sleeps until a key moves and then goes on at the
 * moment of the next look, so that results and times are the same. The state known to waits is one for all threads;
 * waiting on several threads at a time is not supported by leJOS, and neither here.
 */
public class EV3Keys implements Keys {
    private static final int DEBOUNCE_MILLIS = 10;
    private static final int DEFAULT_CLICK_VOLUME = 20;
    private static final int DEFAULT_CLICK_MILLIS = 50;
    private static final int DEFAULT_CLICK_HERTZ = 1000;
    private static final int RELEASED_SHIFT = 8;

    private final List<EV3Key> listened = new ArrayList<>();
    private volatile int knownToWaits;
    private volatile int knownToReads;
    private volatile int simulated;
    private volatile int clickVolume = SystemSettings.getIntSetting(VOL_SETTING, DEFAULT_CLICK_VOLUME);
    private volatile int clickMillis = SystemSettings.getIntSetting(LEN_SETTING, DEFAULT_CLICK_MILLIS);
    private volatile int clickHertz = SystemSettings.getIntSetting(FREQ_SETTING, DEFAULT_CLICK_HERTZ);
    private Thread dispatcher;

    /** The keys of the local brick. */
    public EV3Keys() {}

    @Override
    public void discardEvents() {
        knownToWaits = getButtons();
    }

    @Override
    public int waitForAnyEvent() {
        return waitForAnyEvent(0);
    }

    @Override
    public int waitForAnyEvent(int timeout) {
        return awaitEvent(KeyPolls.forProgram(timeout));
    }

    @Override
    public int waitForAnyPress() {
        return waitForAnyPress(0);
    }

    @Override
    public int waitForAnyPress(int timeout) {
        KeyPolls polls = KeyPolls.forProgram(timeout);
        int state = readButtons();
        int pressed = state & ~knownToWaits;
        knownToWaits = state;
        while (pressed == 0) {
            if (!polls.awaitNext(state)) {
                return 0;
            }
            state = readButtons();
            pressed = state & ~knownToWaits;
            knownToWaits = state;
        }
        return pressed;
    }

    private int awaitEvent(KeyPolls polls) {
        int before = knownToWaits;
        int state = readButtons();
        while (state == before) {
            if (!polls.awaitNext(state)) {
                return 0;
            }
            state = readButtons();
        }
        Delay.msDelay(KeyPolls.PERIOD_MILLIS);
        state |= readButtons();
        knownToWaits = state;
        return state & ~before | (before & ~state) << RELEASED_SHIFT;
    }

    @Override
    public int getButtons() {
        return getButtons(ID_ALL);
    }

    private static int getButtons(int asked) {
        KeySocket socket = BrickAccess.brick().keys();
        int state = socket.pressed(asked);
        while (state != 0) {
            Delay.msDelay(DEBOUNCE_MILLIS);
            int again = socket.pressed(asked);
            if (again == state) {
                return state;
            }
            state = again;
        }
        return 0;
    }

    @Override
    public int readButtons() {
        return readButtons(ID_ALL);
    }

    /** Reads all keys because the program asks for some. */
    int readButtons(int asked) {
        int state = getButtons(asked);
        int pressed = state & ~knownToReads;
        knownToReads = state;
        if (pressed != 0) {
            click();
        }
        return state;
    }

    private void click() {
        if (clickVolume != 0 && clickHertz != 0) {
            Audio audio = EV3Audio.getAudio();
            audio.playTone(clickHertz, clickMillis, -clickVolume);
        }
    }

    @Override
    public void setKeyClickVolume(int vol) {
        clickVolume = vol;
    }

    @Override
    public int getKeyClickVolume() {
        return clickVolume;
    }

    @Override
    public void setKeyClickLength(int len) {
        clickMillis = len;
    }

    @Override
    public int getKeyClickLength() {
        return clickMillis;
    }

    @Override
    public void setKeyClickTone(int key, int freq) {
        clickHertz = freq;
    }

    @Override
    public int getKeyClickTone(int key) {
        return clickHertz;
    }

    /** Makes exactly these keys look pressed by the program. */
    public void setSimultedState(int newState) {
        KeySocket socket = BrickAccess.brick().keys();
        int before = simulated;
        simulated = newState;
        socket.simulate(before & ~newState, false);
        socket.simulate(newState & ~before, true);
    }

    /** Keys that look pressed by the program. */
    public int getSimulatedState() {
        return simulated;
    }

    /** Lets a key hear of events; the first one starts the thread that calls the listeners. */
    synchronized void dispatchTo(EV3Key key) {
        if (!listened.contains(key)) {
            listened.add(key);
        }
        if (dispatcher == null) {
            dispatcher = new Thread(this::dispatchForEver, "key listeners");
            dispatcher.setDaemon(true);
            dispatcher.start();
        }
    }

    private void dispatchForEver() {
        while (true) {
            int event = awaitEvent(KeyPolls.forListeners());
            int moved = (event | event >> RELEASED_SHIFT) & ID_ALL;
            for (EV3Key key : listenedKeys()) {
                if ((key.getId() & moved) != 0) {
                    key.callListeners();
                }
            }
        }
    }

    private synchronized List<EV3Key> listenedKeys() {
        return List.copyOf(listened);
    }
}
