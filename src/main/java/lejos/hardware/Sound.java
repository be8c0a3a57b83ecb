package lejos.hardware;

import java.io.File;
import lejos.utility.Delay;

/** The loudspeaker of the default brick. All sounds block until they are over. */
public class Sound implements Sounds {
    /** Setting: master volume. */
    public static final String VOL_SETTING = "lejos.volume";
    /** Frequency of the note C2 in hertz. */
    public static int C2 = 523;

    /** The loudspeaker. */
    protected static final Audio audio = BrickFinder.getDefault().getAudio();

    private Sound() {}

    /**
     * Plays a system sound.
     *
     * @param queued ignored
     * @param code 0 to 4; other numbers are silent
     */
    public static void systemSound(boolean queued, int code) {
        audio.systemSound(code);
    }

    /** Beeps once: 200 ms. */
    public static void beep() {
        audio.systemSound(BEEP);
    }

    /** Beeps twice: 350 ms. */
    public static void twoBeeps() {
        audio.systemSound(DOUBLE_BEEP);
    }

    /** Plays four falling tones: 400 ms. */
    public static void beepSequence() {
        audio.systemSound(DESCENDING);
    }

    /** Plays four rising tones: 400 ms. */
    public static void beepSequenceUp() {
        audio.systemSound(ASCENDING);
    }

    /** Buzzes: 500 ms. */
    public static void buzz() {
        audio.systemSound(BUZZ);
    }

    /** Waits, in milliseconds; cannot be interrupted. */
    public static void pause(int t) {
        Delay.msDelay(t);
    }

    /** Time left of the present sound: always 0, because sounds block. */
    public static int getTime() {
        return 0;
    }

    /**
     * Plays a tone of {@code aFrequency} hertz for {@code aDuration} ms; volume as in {@link Audio#playTone(int, int,
     * int)}.
     */
    public static void playTone(int aFrequency, int aDuration, int aVolume) {
        audio.playTone(aFrequency, aDuration, aVolume);
    }

    /** Plays a tone of {@code freq} hertz for {@code duration} ms at the master volume. */
    public static void playTone(int freq, int duration) {
        audio.playTone(freq, duration);
    }

    /** Plays a WAV file; see {@link Audio#playSample(File, int)}. */
    public static int playSample(File file, int vol) {
        return audio.playSample(file, vol);
    }

    /** Plays a WAV file at the master volume; see {@link Audio#playSample(File, int)}. */
    public static int playSample(File file) {
        return audio.playSample(file);
    }

    /** Plays unsigned 8-bit samples; see {@link Audio#playSample(byte[], int, int, int, int)}. */
    public static int playSample(byte[] data, int offset, int len, int freq, int vol) {
        return audio.playSample(data, offset, len, freq, vol);
    }

    /** Plays a note of {@code freq} hertz for {@code len} ms on an instrument. */
    public static void playNote(int[] inst, int freq, int len) {
        audio.playNote(inst, freq, len);
    }

    /** Sets the master volume, limited to 0 to 100. */
    public static void setVolume(int vol) {
        audio.setVolume(vol);
    }

    /** Master volume, 0 to 100; 80 at the start. */
    public static int getVolume() {
        return audio.getVolume();
    }

    /** Takes the master volume from the settings again. */
    public static void loadSettings() {
        audio.loadSettings();
    }
}
