package brickless.device.panel;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.hardware.ScreenSocket;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class ScreenPanelTest {
    private final PanelBench bench = new PanelBench();
    private final ScreenPanel screen = bench.screen;

    @Test
    void visibleLayersAreCombined() {
        screen.layer("a")[0] = 0b01;
        screen.layer("b")[0] = 0b10;
        screen.refresh();
        assertThat(screen.displayed()[0]).isEqualTo((byte) 0b11);
        screen.setVisible("a", false);
        assertThat(screen.displayed()[0]).as("not before the next copy").isEqualTo((byte) 0b11);
        screen.refresh();
        assertThat(screen.displayed()[0]).isEqualTo((byte) 0b10);
    }

    @Test
    void aLayerIsFoundAgainByName() {
        assertThat(screen.layer("a")).isSameAs(screen.layer("a")).hasSize(2944);
        assertThat(screen.layer("b")).isNotSameAs(screen.layer("a"));
    }

    @Test
    void oneSelfRefreshingVisibleLayerCopiesAll() {
        screen.layer("a")[0] = 1;
        screen.layer("b");
        screen.setAutoRefresh("a", false);
        bench.processor().charge(300_000_000);
        assertThat(screen.displayed()[0]).as("b still refreshes itself").isOne();
        screen.setAutoRefresh("b", false);
        screen.layer("a")[0] = 0;
        bench.processor().charge(300_000_000);
        assertThat(screen.displayed()[0]).isOne();
        screen.settle();
        assertThat(screen.displayed()[0]).isZero();
    }

    @Test
    void unchangedPicturesAreNotReported() {
        screen.layer("a")[5] = 1;
        bench.processor().charge(2_000_000_000);
        screen.refresh();
        assertThat(bench.events()).containsExactly("screen");
    }

    @Test
    void callsCharge() {
        screen.refresh();
        assertThat(bench.millis()).isEqualTo(0.2);
        screen.drawn(17 * 160);
        assertThat(bench.millis()).isBetween(0.69, 0.71);
    }

    @Test
    void screenHas178By128DotsOfOneBit() {
        assertThat(ScreenSocket.WIDTH).isEqualTo(178);
        assertThat(ScreenSocket.HEIGHT).isEqualTo(128);
        assertThat(ScreenSocket.ROW_BYTES).isEqualTo((178 + 7) / 8);
    }

    @Test
    void pngShowsEveryDotTwiceAsLargeInsideItsMargin() throws IOException {
        byte[] picture = new byte[ScreenSocket.ROW_BYTES * ScreenSocket.HEIGHT];
        int[][] dots = {{0, 0}, {177, 0}, {9, 64}, {0, 127}, {177, 127}};
        for (int[] dot : dots) {
            picture[dot[1] * ScreenSocket.ROW_BYTES + dot[0] / 8] |= (byte) (1 << dot[0] % 8);
        }
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(ScreenImage.png(picture)));
        assertThat(image.getWidth()).isEqualTo(ScreenImage.WIDTH);
        assertThat(image.getHeight()).isEqualTo(ScreenImage.HEIGHT);
        int background = image.getRGB(0, 0);
        int black = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                black += image.getRGB(x, y) != background ? 1 : 0;
            }
        }
        assertThat(black).isEqualTo(dots.length * 4);
        for (int[] dot : dots) {
            assertThat(image.getRGB(8 + 2 * dot[0] + 1, 8 + 2 * dot[1] + 1)).isNotEqualTo(background);
        }
    }
}
