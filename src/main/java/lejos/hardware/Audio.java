package lejos.hardware;

import java.io.File;

/** The loudspeaker. All sounds block until they are over. */
public interface Audio extends Sounds {
    /** Plays a system sound, 0 to 4; other numbers are silent. */
    void systemSound(int code);

    /**
     * Plays a tone.
     *
     * @param frequency hertz
     * @param duration milliseconds
     * @param volume percent of the master volume; if negative, its amount is the percentage of full loudness
     */
    void playTone(int frequency, int duration, int volume);

    /** Plays a tone at the master volume. */
    void playTone(int freq, int duration);

    /**
     * Plays a WAV file: PCM, mono, 8 or 16 bit, 8 to 48 kHz.
     *
     * @param vol percent, as for {@link #playTone(int, int, int)}
     * @return 0, or a negative error number: −9 missing or shorter than 44 bytes, −1 not RIFF or unreadable, −2 not
     *     WAVE, −3 no format, −4 not PCM, −5 not mono, −6 not 8 or 16 bit, −7 above 48 kHz
     * @throws UnsupportedOperationException below 8 kHz
     */
    int playSample(File file, int vol);

    /** Plays a WAV file at the master volume. */
    int playSample(File file);

    /**
     * Plays unsigned 8-bit samples.
     *
     * @param freq samples per second
     * @param vol percent, as for {@link #playTone(int, int, int)}
     * @return {@code len}
     */
    int playSample(byte[] data, int offset, int len, int freq, int vol);

    /**
     * Plays a note.
     *
     * @param inst instrument, e.g. {@link Sounds#PIANO}
     * @param freq hertz
     * @param len milliseconds
     */
    void playNote(int[] inst, int freq, int len);

    /** Sets the master volume, limited to 0 to 100. */
    void setVolume(int vol);

    /** Master volume, 0 to 100; 80 at the start. */
    int getVolume();

    /** Takes the master volume from the settings again. */
    void loadSettings();
}
