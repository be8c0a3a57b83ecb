package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import java.io.File;
import lejos.hardware.Audio;
import lejos.internal.io.SystemSettings;
import lejos.utility.Delay;

/** The loudspeaker: hands sounds to the socket and waits until they are over. */
public class EV3Audio implements Audio {
    /** Setting: master volume. */
    public static final String VOL_SETTING = "lejos.volume";

    private static final int DEFAULT_VOLUME = 80;
    private static final int MILLIS_PER_SECOND = 1000;
    private static final int BEEP_HERTZ = 600;
    private static final int[] RISING_HERTZ = {523, 653, 784, 915};
    private static final EV3Audio AUDIO = new EV3Audio();

    private volatile int masterVolume;

    private EV3Audio() {
        loadSettings();
    }

    /** The loudspeaker of the local brick. */
    public static Audio getAudio() {
        return AUDIO;
    }

    @Override
    public void systemSound(int code) {
        switch (code) {
            case BEEP -> playTone(BEEP_HERTZ, 200);
            case DOUBLE_BEEP -> doubleBeep();
            case ASCENDING -> rising();
            case DESCENDING -> falling();
            case BUZZ -> playTone(100, 500);
            default -> { }
        }
    }

    private void doubleBeep() {
        playTone(BEEP_HERTZ, 150);
        Delay.msDelay(50);
        playTone(BEEP_HERTZ, 150);
    }

    private void rising() {
        for (int hertz : RISING_HERTZ) {
            playTone(hertz, 100);
        }
    }

    private void falling() {
        for (int i = RISING_HERTZ.length - 1; i >= 0; i--) {
            playTone(RISING_HERTZ[i], 100);
        }
    }

    @Override
    public void playTone(int frequency, int duration, int volume) {
        BrickAccess.brick().speaker().tone(frequency, Math.max(0, duration), loudness(volume));
        Delay.msDelay(duration);
    }

    @Override
    public void playTone(int freq, int duration) {
        playTone(freq, duration, VOL_MAX);
    }

    /** Percent of full loudness: positive volumes are scaled by the master volume, negative ones are not. */
    private int loudness(int volume) {
        int percent = volume >= 0 ? volume * masterVolume / VOL_MAX : -volume;
        return Math.min(VOL_MAX, percent);
    }

    @Override
    public int playSample(File file, int vol) {
        WaveFile wave = WaveFile.read(file);
        if (wave.error() == 0) {
            play(file.getName(), wave.durationMillis(), vol);
        }
        return wave.error();
    }

    @Override
    public int playSample(File file) {
        return playSample(file, VOL_MAX);
    }

    @Override
    public int playSample(byte[] data, int offset, int len, int freq, int vol) {
        play("pcm", (int) ((long) len * MILLIS_PER_SECOND / freq), vol);
        return len;
    }

    private void play(String name, int durationMillis, int vol) {
        BrickAccess.brick().speaker().sample(name, durationMillis, loudness(vol));
        Delay.msDelay(durationMillis);
    }

    @Override
    public void playNote(int[] inst, int freq, int len) {
        playTone(freq, len);
    }

    @Override
    public void setVolume(int vol) {
        masterVolume = Math.max(0, Math.min(VOL_MAX, vol));
    }

    @Override
    public int getVolume() {
        return masterVolume;
    }

    @Override
    public void loadSettings() {
        setVolume(SystemSettings.getIntSetting(VOL_SETTING, DEFAULT_VOLUME));
    }
}
