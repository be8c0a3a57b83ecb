package lejos.hardware.video;

import static org.assertj.core.api.Assertions.assertThat;

import lejos.hardware.lcd.Image;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class YUYVImageTest {
    /** Two pairs of pixels one above the other, with brightness 10, 200, 100 and 101. */
    private final YUYVImage picture = new YUYVImage(new byte[] {10, 1, (byte) 200, 2, 100, 3, 101, 4}, 2, 2);

    @Test
    void twoPixelsShareTheirColour() {
        assertThat(picture.getY(0, 0)).isEqualTo(10);
        assertThat(picture.getY(1, 0)).as("a signed byte").isEqualTo(200 - 256);
        assertThat(picture.getU(0, 1)).isEqualTo(3).isEqualTo(picture.getU(1, 1));
        assertThat(picture.getV(0, 0)).isEqualTo(2).isEqualTo(picture.getV(1, 0));
    }

    @Test
    void sizesAndMeanBrightness() {
        assertThat(picture.getNumPixels()).isEqualTo(4);
        assertThat(picture.getMeanY()).isEqualTo((10 + 200 + 100 + 101) / 4);
        YUYVImage empty = new YUYVImage(6, 4);
        assertThat(empty.getWidth() * 10 + empty.getHeight()).isEqualTo(64);
        assertThat(empty.getMeanY()).isZero();
    }

    @Test
    void pixelsAboveTheThresholdAreWhite() {
        Image screen = Image.createImage(8, 8);
        picture.display(screen.getGraphics(), 3, 1, 100);
        assertThat(screen.getData()[1]).as("only the dark pixel of the upper row").isEqualTo((byte) 0b1000);
        assertThat(screen.getData()[2]).as("100 is not brighter than 100").isEqualTo((byte) 0b1000);
    }

    @Test
    void formatsAreFourCharacters() {
        assertThat(Video.PIX_FMT_YUYV).isEqualTo(0x56595559);
        assertThat(VideoUtils.fourcc('M', 'J', 'P', 'G')).isEqualTo(Video.PIX_FMT_MJPEG).isEqualTo(0x47504a4d);
    }
}
