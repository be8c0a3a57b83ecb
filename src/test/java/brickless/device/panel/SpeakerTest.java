package brickless.device.panel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SpeakerTest {
    private final PanelBench bench = new PanelBench();
    private final Speaker speaker = bench.speaker;

    private boolean playing() {
        return speaker.playing(bench.processor().nowNanos());
    }

    @Test
    void soundsLastTheirTimeAndDoNotBlock() {
        speaker.tone(440, 100, 50);
        assertThat(bench.millis()).isLessThan(1);
        assertThat(playing()).isTrue();
        bench.processor().charge(100_000_000);
        assertThat(playing()).isFalse();
    }

    @Test
    void silenceEndsWhatIsPlayingAndIsOnlyThenReported() {
        speaker.silence();
        speaker.sample("horn.wav", 2000, 80);
        speaker.silence();
        speaker.silence();
        assertThat(playing()).isFalse();
        assertThat(bench.events()).containsExactly("sample horn.wav 2000 ms 80 %", "silence");
    }

    @Test
    void aNewSoundReplacesTheOldOne() {
        speaker.tone(440, 5000, 50);
        speaker.tone(880, 10, 50);
        bench.processor().charge(20_000_000);
        assertThat(playing()).isFalse();
    }

    @Test
    void ledsReportChangesOnlyAndGoOffWithTheMenu() {
        bench.leds.setPattern(7);
        bench.leds.setPattern(7);
        assertThat(bench.leds.pattern()).isEqualTo(7);
        bench.leds.switchOff();
        assertThat(bench.events()).containsExactly("led 7", "led 0");
    }
}
