package lejos.hardware;

/**
 * Numbers of the system sounds, and instruments. An instrument is {attack, decay, decay drop, sustain drop, release}.
 */
public interface Sounds {
    /** Instrument: piano. */
    int[] PIANO = {4, 25, 500, 7000, 5};
    /** Instrument: flute. */
    int[] FLUTE = {10, 25, 2000, 1000, 25};
    /** Instrument: xylophone. */
    int[] XYLOPHONE = {1, 8, 3000, 5000, 5};
    /** System sound: one beep. */
    int BEEP = 0;
    /** System sound: two beeps. */
    int DOUBLE_BEEP = 1;
    /** System sound: four rising tones. */
    int ASCENDING = 2;
    /** System sound: four falling tones. */
    int DESCENDING = 3;
    /** System sound: a low buzz. */
    int BUZZ = 4;
    /** Highest volume. */
    int VOL_MAX = 100;
}
