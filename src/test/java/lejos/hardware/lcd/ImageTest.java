package lejos.hardware.lcd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class ImageTest {
    private static String rows(Image image) {
        StringBuilder text = new StringBuilder();
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                text.append(image.getGraphics().getPixel(x, y) == 1 ? '#' : '.');
            }
            text.append('\n');
        }
        return text.toString();
    }

    private static Image picture() {
        return new Image(3, 2, new byte[] {0b001, 0b011});
    }

    @Test
    void wrapsItsArray() {
        byte[] data = {0b101};
        Image image = new Image(3, 1, data);
        assertThat(image.getData()).isSameAs(data);
        assertThat(rows(image)).isEqualTo("#.#\n");
    }

    @Test
    void singlePixelsOfAnImageCanBeSet() {
        Image image = Image.createImage(3, 1);
        image.getGraphics().setPixel(1, 0, 1);
        image.getGraphics().refresh();
        assertThat(rows(image)).isEqualTo(".#.\n");
    }

    @Test
    void wideLowImagesHaveRoomForAllRows() {
        Image image = Image.createImage(178, 10);
        image.getGraphics().fillRect(0, 0, 178, 10);
        assertThat(rows(image)).doesNotContain(".");
        assertThat(Image.createImage(16, 16).getData()).hasSize(32);
        assertThat(Image.createImage(100, 9).getData()).as("the size of leJOS where that is enough").hasSize(200);
    }

    @Test
    void readsItsFileFormat() throws IOException {
        byte[] file = {'L', 'N', 'I', '0', 0, 8, 0, 2, 0x0f, (byte) 0x80, 0, 0, 0, 0, 0, 0};
        Image image = Image.createImage(new ByteArrayInputStream(file));
        assertThat(rows(image)).isEqualTo("####....\n.......#\n");
        file[3] = '1';
        assertThatThrownBy(() -> Image.createImage(new ByteArrayInputStream(file)))
                .isInstanceOf(IOException.class).hasMessage("File format error!");
    }

    @Test
    void transformsTurnAndMirror() {
        String[] expected = new String[8];
        expected[GraphicsLCD.TRANS_NONE] = "#..\n##.\n";
        expected[GraphicsLCD.TRANS_MIRROR] = "..#\n.##\n";
        expected[GraphicsLCD.TRANS_MIRROR_ROT180] = "##.\n#..\n";
        expected[GraphicsLCD.TRANS_ROT180] = ".##\n..#\n";
        expected[GraphicsLCD.TRANS_ROT90] = "##\n#.\n..\n";
        expected[GraphicsLCD.TRANS_ROT270] = "..\n.#\n##\n";
        expected[GraphicsLCD.TRANS_MIRROR_ROT270] = "##\n.#\n..\n";
        expected[GraphicsLCD.TRANS_MIRROR_ROT90] = "..\n#.\n##\n";
        for (int transform = 0; transform < 8; transform++) {
            assertThat(rows(Image.createImage(picture(), 0, 0, 3, 2, transform))).as("transform " + transform)
                    .isEqualTo(expected[transform]);
        }
    }

    @Test
    void partsOutsideThePictureAreWhite() {
        assertThat(rows(Image.createImage(picture(), 1, 0, 3, 3, GraphicsLCD.TRANS_MIRROR)))
                .isEqualTo("...\n..#\n...\n");
    }
}
