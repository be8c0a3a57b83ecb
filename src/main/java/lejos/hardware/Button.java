package lejos.hardware;

/** The keys of the default brick. */
public class Button {
    /** Bit of the UP key. */
    public static final int ID_UP = 0x1;
    /** Bit of the ENTER key. */
    public static final int ID_ENTER = 0x2;
    /** Bit of the DOWN key. */
    public static final int ID_DOWN = 0x4;
    /** Bit of the RIGHT key. */
    public static final int ID_RIGHT = 0x8;
    /** Bit of the LEFT key. */
    public static final int ID_LEFT = 0x10;
    /** Bit of the ESCAPE key. */
    public static final int ID_ESCAPE = 0x20;
    /** All bits. */
    public static final int ID_ALL = 0x3f;
    /** Setting: loudness of the key click. */
    public static final String VOL_SETTING = "lejos.keyclick_volume";
    /** Setting: length of the key click. */
    public static final String LEN_SETTING = "lejos.keyclick_length";
    /** Setting: pitch of the key click. */
    public static final String FREQ_SETTING = "lejos.keyclick_frequency";

    /** All keys together. */
    public static final Keys keys = BrickFinder.getDefault().getKeys();
    /** The ENTER key. */
    public static final Key ENTER = BrickFinder.getDefault().getKey("Enter");
    /** The LEFT key. */
    public static final Key LEFT = BrickFinder.getDefault().getKey("Left");
    /** The RIGHT key. */
    public static final Key RIGHT = BrickFinder.getDefault().getKey("Right");
    /** The ESCAPE key. */
    public static final Key ESCAPE = BrickFinder.getDefault().getKey("Escape");
    /** The UP key. */
    public static final Key UP = BrickFinder.getDefault().getKey("Up");
    /** The DOWN key. */
    public static final Key DOWN = BrickFinder.getDefault().getKey("Down");

    private Button() {}

    /** Takes the present state as known; see {@link Keys#discardEvents()}. */
    public static void discardEvents() {
        keys.discardEvents();
    }

    /** Waits for a key to go down or up; see {@link Keys#waitForAnyEvent(int)}. */
    public static int waitForAnyEvent() {
        return keys.waitForAnyEvent();
    }

    /** Waits for a key to go down or up; see {@link Keys#waitForAnyEvent(int)}. */
    public static int waitForAnyEvent(int timeout) {
        return keys.waitForAnyEvent(timeout);
    }

    /** Waits for a key to go down; see {@link Keys#waitForAnyPress(int)}. */
    public static int waitForAnyPress(int timeout) {
        return keys.waitForAnyPress(timeout);
    }

    /** Waits for a key to go down; see {@link Keys#waitForAnyPress(int)}. */
    public static int waitForAnyPress() {
        return keys.waitForAnyPress();
    }

    /** Keys that are down, without a click. */
    public static int getButtons() {
        return keys.getButtons();
    }

    /** Keys that are down; clicks when a key has gone down since the last call. */
    public static int readButtons() {
        return keys.readButtons();
    }

    /** Loudness of the click, 0 to 100; 0 = no click. */
    public static void setKeyClickVolume(int vol) {
        keys.setKeyClickVolume(vol);
    }

    /** Loudness of the click, 0 to 100. */
    public static synchronized int getKeyClickVolume() {
        return keys.getKeyClickVolume();
    }

    /** Length of the click in milliseconds. */
    public static synchronized void setKeyClickLength(int len) {
        keys.setKeyClickLength(len);
    }

    /** Length of the click in milliseconds. */
    public static synchronized int getKeyClickLength() {
        return keys.getKeyClickLength();
    }

    /** Pitch of the click in hertz, 0 = no click; {@code key} is ignored. */
    public static synchronized void setKeyClickTone(int key, int freq) {
        keys.setKeyClickTone(key, freq);
    }

    /** Pitch of the click in hertz. */
    public static synchronized int getKeyClickTone(int key) {
        return keys.getKeyClickTone(key);
    }

    /** Shows an LED pattern on the default brick; see {@link LED#setPattern(int)}. */
    public static void LEDPattern(int pattern) {
        BrickFinder.getDefault().getLED().setPattern(pattern);
    }
}
