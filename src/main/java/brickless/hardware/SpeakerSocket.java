package brickless.hardware;

/** The loudspeaker. Methods record and start a sound and return at once; callers wait for its duration themselves. */
public interface SpeakerSocket {
    /**
     * Starts a tone.
     *
     * @param frequencyHertz tone, 0 = silence
     * @param durationMillis length
     * @param volumePercent loudness 0 to 100, master volume already applied
     */
    void tone(int frequencyHertz, int durationMillis, int volumePercent);

    /**
     * Starts a sample.
     *
     * @param name file name or {@code pcm}
     * @param durationMillis length
     * @param volumePercent loudness 0 to 100
     */
    void sample(String name, int durationMillis, int volumePercent);

    /** Ends whatever is playing. */
    void silence();
}
