package lejos.hardware.lcd;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntFunction;
import lejos.realm.OriginalScreen;
import org.junit.jupiter.api.Test;

/** Lines, rectangles, text, images and raster operations give the pixels of the published classes. */
class DrawingAgainstOriginalTest {
    private static final int PICTURES = 3000;

    @Test
    void picturesAreTheSame() {
        IntFunction<Object> original = OriginalScreen.linked(DrawingDriver.class);
        for (int index = 0; index < PICTURES; index++) {
            byte[] expected = (byte[]) original.apply(index);
            assertThat(rows(DrawingDriver.play(index))).as("index " + index).isEqualTo(rows(expected));
        }
    }

    private static String rows(byte[] picture) {
        StringBuilder text = new StringBuilder();
        for (int y = 0; y < DrawingDriver.HEIGHT; y++) {
            for (int x = 0; x < DrawingDriver.WIDTH; x++) {
                int index = y * ((DrawingDriver.WIDTH + 7) / 8) + x / 8;
                text.append((picture[index] >> x % 8 & 1) != 0 ? '#' : '.');
            }
            text.append('\n');
        }
        return text.toString();
    }
}
