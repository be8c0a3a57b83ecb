package lejos.robotics.filter;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.device.panel.PanelBench;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class DumpTest {
    private PanelBench bench;

    @Test
    void valuesAreShownAndPassedOn() {
        float[] plain = new float[3];
        float[] dumped = new float[3];
        new RandomSource(3, 2, 0).fetchSample(plain, 1);
        new Dump(new RandomSource(3, 2, 0)).fetchSample(dumped, 1);
        assertThat(dumped).isEqualTo(plain);
        assertThat(bench.screen().asText()).contains(String.format("%7.3f", plain[1]))
                .contains(String.format("%7.3f", plain[2]));
    }
}
