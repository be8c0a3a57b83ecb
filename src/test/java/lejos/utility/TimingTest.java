package lejos.utility;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.device.panel.PanelBench;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class TimingTest {
    private PanelBench bench;

    @Test
    void delayLastsAtLeastItsTimeAndNothingForNothing() {
        Delay.msDelay(0);
        Delay.msDelay(-7);
        assertThat(bench.millis()).isZero();
        Delay.msDelay(500);
        assertThat(bench.millis()).isCloseTo(500, within(0.1));
    }

    @Test
    void fineDelaysEndExactly() {
        Delay.usDelay(2500);
        assertThat(bench.millis()).isCloseTo(2.5, within(0.01));
        Delay.nsDelay(300_000);
        assertThat(bench.millis()).isCloseTo(2.8, within(0.02));
    }

    @Test
    void anInterruptDoesNotShortenADelayAndStaysMarked() {
        Thread.currentThread().interrupt();
        Delay.msDelay(300);
        assertThat(bench.millis()).isCloseTo(300, within(0.1));
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void stopwatchCountsFromCreationAndReset() {
        Stopwatch watch = new Stopwatch();
        Delay.msDelay(120);
        assertThat(watch.elapsed()).isEqualTo(120);
        watch.reset();
        assertThat(watch.elapsed()).isZero();
        Delay.msDelay(5);
        assertThat(watch.elapsed()).isEqualTo(5);
    }

    @Test
    void integrationIsTrapezoidal() {
        Integration integration = new Integration(10, 0);
        Delay.msDelay(1000);
        assertThat(integration.addReading(4)).isCloseTo(12, within(0.01));
        Delay.msDelay(500);
        assertThat(integration.addReading(4)).isCloseTo(14, within(0.01));
    }
}
