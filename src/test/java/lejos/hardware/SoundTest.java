package lejos.hardware;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.device.panel.PanelBench;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lejos.hardware.ev3.LocalEV3;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class SoundTest {
    private static final double CALL_MS = 3;

    private PanelBench bench;

    private double lasts(Runnable sound) {
        double before = bench.millis();
        sound.run();
        return bench.millis() - before;
    }

    @Test
    void systemSoundsBlockForTheirLength() {
        assertThat(lasts(Sound::beep)).isCloseTo(200, within(CALL_MS));
        assertThat(lasts(Sound::twoBeeps)).isCloseTo(350, within(CALL_MS));
        assertThat(lasts(Sound::beepSequenceUp)).isCloseTo(400, within(CALL_MS));
        assertThat(lasts(Sound::beepSequence)).isCloseTo(400, within(CALL_MS));
        assertThat(lasts(Sound::buzz)).isCloseTo(500, within(CALL_MS));
        assertThat(lasts(() -> Sound.systemSound(true, 7))).as("unknown code").isLessThan(1);
    }

    @Test
    void risingAndFallingSequencesAreFourTones() {
        Sound.beepSequenceUp();
        Sound.beepSequence();
        assertThat(bench.events()).containsExactly(
                "tone 523 Hz 100 ms 80 %", "tone 653 Hz 100 ms 80 %", "tone 784 Hz 100 ms 80 %",
                "tone 915 Hz 100 ms 80 %",
                "tone 915 Hz 100 ms 80 %", "tone 784 Hz 100 ms 80 %", "tone 653 Hz 100 ms 80 %",
                "tone 523 Hz 100 ms 80 %");
    }

    @Test
    void positiveVolumesAreScaledByTheMasterVolumeAndNegativeOnesAreNot() {
        assertThat(Sound.getVolume()).isEqualTo(80);
        Sound.setVolume(50);
        Sound.playTone(440, 10);
        Sound.playTone(440, 10, 30);
        Sound.playTone(440, 10, -30);
        Sound.setVolume(120);
        Sound.playTone(440, 10);
        Sound.setVolume(-5);
        assertThat(Sound.getVolume()).isZero();
        Sound.loadSettings();
        assertThat(Sound.getVolume()).isEqualTo(80);
        assertThat(bench.events()).containsExactly(
                "tone 440 Hz 10 ms 50 %", "tone 440 Hz 10 ms 15 %", "tone 440 Hz 10 ms 30 %",
                "tone 440 Hz 10 ms 100 %");
    }

    @Test
    void theBricksAudioIsTheSameLoudspeaker() {
        LocalEV3.get().getAudio().setVolume(10);
        assertThat(Sound.getVolume()).isEqualTo(10);
        assertThat(lasts(() -> Sound.playNote(Sounds.PIANO, 440, 300))).isCloseTo(300, within(CALL_MS));
        assertThat(Sound.getTime()).isZero();
        assertThat(Sound.C2).isEqualTo(523);
    }

    @Test
    void aNoteIsOneTone() {
        assertThat(lasts(() -> Sound.playNote(Sounds.PIANO, 440, 300))).isCloseTo(300, within(CALL_MS));
        assertThat(bench.events()).containsExactly("tone 440 Hz 300 ms 80 %");
    }

    @Test
    void rawSamplesLastAsLongAsTheirRateSays() {
        assertThat(lasts(() -> assertThat(Sound.playSample(new byte[4000], 0, 4000, 8000, 100)).isEqualTo(4000)))
                .isCloseTo(500, within(CALL_MS));
    }

    @Test
    void wavFilesLastAsLongAsTheirDataChunk() throws IOException {
        File file = wave("RIFF", "WAVE", "fmt ", 1, 1, 8000, 16, 16_000);
        assertThat(lasts(() -> assertThat(Sound.playSample(file)).isZero())).isCloseTo(1000, within(CALL_MS));
        assertThat(bench.events()).containsExactly("sample " + file.getName() + " 1000 ms 80 %");
    }

    @Test
    void badWavFilesHaveTheirErrorNumbers() throws IOException {
        assertThat(Sound.playSample(new File("no-such-file.wav"))).isEqualTo(-9);
        assertThat(Sound.playSample(wave("RIFX", "WAVE", "fmt ", 1, 1, 8000, 8, 8))).isEqualTo(-1);
        assertThat(Sound.playSample(wave("RIFF", "WAVX", "fmt ", 1, 1, 8000, 8, 8))).isEqualTo(-2);
        assertThat(Sound.playSample(wave("RIFF", "WAVE", "fmtx", 1, 1, 8000, 8, 8))).isEqualTo(-3);
        assertThat(Sound.playSample(wave("RIFF", "WAVE", "fmt ", 2, 1, 8000, 8, 8))).isEqualTo(-4);
        assertThat(Sound.playSample(wave("RIFF", "WAVE", "fmt ", 1, 2, 8000, 8, 8))).isEqualTo(-5);
        assertThat(Sound.playSample(wave("RIFF", "WAVE", "fmt ", 1, 1, 8000, 24, 8))).isEqualTo(-6);
        assertThat(Sound.playSample(wave("RIFF", "WAVE", "fmt ", 1, 1, 96_000, 8, 8))).isEqualTo(-7);
        File slow = wave("RIFF", "WAVE", "fmt ", 1, 1, 4000, 8, 8);
        assertThatThrownBy(() -> Sound.playSample(slow)).isInstanceOf(UnsupportedOperationException.class);
        assertThat(bench.events()).isEmpty();
    }

    private static File wave(String riff, String type, String format, int coding, int channels, int rate, int bits,
            int dataBytes)
            throws IOException {
        ByteBuffer file = ByteBuffer.allocate(44 + dataBytes).order(ByteOrder.LITTLE_ENDIAN);
        file.put(riff.getBytes(StandardCharsets.US_ASCII)).putInt(36 + dataBytes)
                .put(type.getBytes(StandardCharsets.US_ASCII));
        file.put(format.getBytes(StandardCharsets.US_ASCII)).putInt(16).putShort((short) coding)
                .putShort((short) channels);
        file.putInt(rate).putInt(rate * channels * bits / 8).putShort((short) (channels * bits / 8))
                .putShort((short) bits);
        file.put("data".getBytes(StandardCharsets.US_ASCII)).putInt(dataBytes);
        Path path = Files.createTempFile("sound", ".wav");
        Files.write(path, file.array());
        path.toFile().deleteOnExit();
        return path.toFile();
    }
}
