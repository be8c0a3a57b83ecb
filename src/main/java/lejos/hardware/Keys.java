package lejos.hardware;

/** All keys of the brick. Masks are made of the {@code ID_} bits. Waiting looks at the keys every 50 ms. */
public interface Keys {
    /** Bit of the UP key. */
    int ID_UP = 0x1;
    /** Bit of the ENTER key. */
    int ID_ENTER = 0x2;
    /** Bit of the DOWN key. */
    int ID_DOWN = 0x4;
    /** Bit of the RIGHT key. */
    int ID_RIGHT = 0x8;
    /** Bit of the LEFT key. */
    int ID_LEFT = 0x10;
    /** Bit of the ESCAPE key. */
    int ID_ESCAPE = 0x20;
    /** All bits. */
    int ID_ALL = 0x3f;
    /** Number of keys. */
    int NUM_KEYS = 6;
    /** Setting: loudness of the key click. */
    String VOL_SETTING = "lejos.keyclick_volume";
    /** Setting: length of the key click. */
    String LEN_SETTING = "lejos.keyclick_length";
    /** Setting: pitch of the key click. */
    String FREQ_SETTING = "lejos.keyclick_frequency";

    /** Takes the present state as known, so that waits do not return for keys that are down now. */
    void discardEvents();

    /** Like {@link #waitForAnyEvent(int)} without time limit. */
    int waitForAnyEvent();

    /**
     * Blocks until a key goes down or up.
     *
     * @param timeout limit in milliseconds, 0 = none
     * @return keys that went down in bits 0 to 7, keys that went up in bits 8 to 15; 0 after the time limit or an
     *     interrupt
     */
    int waitForAnyEvent(int timeout);

    /**
     * Blocks until a key is down that was up at the last wait.
     *
     * @param timeout limit in milliseconds, 0 = none
     * @return keys that went down; 0 after the time limit or an interrupt
     */
    int waitForAnyPress(int timeout);

    /** Like {@link #waitForAnyPress(int)} without time limit. */
    int waitForAnyPress();

    /** Keys that are down, without a click; takes 10 ms when a key is down. */
    int getButtons();

    /** Keys that are down; clicks, blocking, when a key has gone down since the last call. */
    int readButtons();

    /** Loudness of the click, 0 to 100; 0 = no click. */
    void setKeyClickVolume(int vol);

    /** Loudness of the click, 0 to 100. */
    int getKeyClickVolume();

    /** Length of the click in milliseconds. */
    void setKeyClickLength(int len);

    /** Length of the click in milliseconds. */
    int getKeyClickLength();

    /**
     * Pitch of the click.
     *
     * @param key ignored: all keys click alike
     * @param freq hertz, 0 = no click
     */
    void setKeyClickTone(int key, int freq);

    /** Pitch of the click in hertz; the same for all keys. */
    int getKeyClickTone(int key);
}
