package lejos.hardware.lcd;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntBinaryOperator;
import org.junit.jupiter.api.Test;

/** All raster operations on all pairs of bits, and copies at all bit offsets. */
class RasterOperationsTest {
    private static final Map<Integer, IntBinaryOperator> TRUTH = new LinkedHashMap<>();

    static {
        TRUTH.put(CommonLCD.ROP_CLEAR, (s, d) -> 0);
        TRUTH.put(CommonLCD.ROP_AND, (s, d) -> s & d);
        TRUTH.put(CommonLCD.ROP_ANDREVERSE, (s, d) -> s & ~d);
        TRUTH.put(CommonLCD.ROP_COPY, (s, d) -> s);
        TRUTH.put(CommonLCD.ROP_ANDINVERTED, (s, d) -> ~s & d);
        TRUTH.put(CommonLCD.ROP_NOOP, (s, d) -> d);
        TRUTH.put(CommonLCD.ROP_XOR, (s, d) -> s ^ d);
        TRUTH.put(CommonLCD.ROP_OR, (s, d) -> s | d);
        TRUTH.put(CommonLCD.ROP_NOR, (s, d) -> ~(s | d));
        TRUTH.put(CommonLCD.ROP_EQUIV, (s, d) -> ~(s ^ d));
        TRUTH.put(CommonLCD.ROP_INVERT, (s, d) -> ~d);
        TRUTH.put(CommonLCD.ROP_ORREVERSE, (s, d) -> s | ~d);
        TRUTH.put(CommonLCD.ROP_COPYINVERTED, (s, d) -> ~s);
        TRUTH.put(CommonLCD.ROP_ORINVERTED, (s, d) -> ~s | d);
        TRUTH.put(CommonLCD.ROP_NAND, (s, d) -> ~(s & d));
        TRUTH.put(CommonLCD.ROP_SET, (s, d) -> 1);
    }

    /** Source 0 1 over 0 1, destination 0 0 over 1 1. */
    @Test
    void truthTablesHold() {
        assertThat(TRUTH).hasSize(16);
        TRUTH.forEach((rop, truth) -> {
            Image picture = new Image(2, 2, new byte[] {0b00, 0b11});
            picture.getGraphics().bitBlt(new byte[] {0b10, 0b10}, 2, 2, 0, 0, 0, 0, 2, 2, rop);
            for (int s = 0; s < 2; s++) {
                for (int d = 0; d < 2; d++) {
                    assertThat(picture.getData()[d] >> s & 1).as("rop %08x of %d on %d", rop, s, d)
                            .isEqualTo(truth.applyAsInt(s, d) & 1);
                }
            }
        });
    }

    @Test
    void operationsThatNeedNoSourceTakeNull() {
        Image picture = new Image(2, 2, new byte[] {0b00, 0b11});
        picture.getGraphics().bitBlt(null, 2, 2, 0, 0, 0, 0, 2, 2, CommonLCD.ROP_INVERT);
        assertThat(picture.getData()).containsExactly(0b11, 0b00);
    }

    @Test
    void neighboursOfTheCopyStayUntouchedAtAllBitOffsets() {
        byte[] source = {(byte) 0b10110011, 0b01101101};
        for (int index = 0; index < 8 * 8 * 9; index++) {
            int from = index % 8;
            int to = index / 8 % 8;
            int width = index / 64;
            Image picture = new Image(24, 1, new byte[] {-1, -1, -1});
            picture.getGraphics().bitBlt(source, 16, 1, from, 0, to, 0, width, 1, CommonLCD.ROP_COPY);
            for (int x = 0; x < 24; x++) {
                boolean copied = x >= to && x < to + width;
                int expected = copied ? source[(from + x - to) / 8] >> (from + x - to) % 8 & 1 : 1;
                assertThat(picture.getData()[x / 8] >> x % 8 & 1).as("index %d, column %d", index, x)
                        .isEqualTo(expected);
            }
        }
    }

    @Test
    void overlappingCopiesAreSafeInAllDirections() {
        for (int index = 0; index < 25; index++) {
            int dx = index % 5 - 2;
            int dy = index / 5 - 2;
            byte[] before = {(byte) 0b10010110, 0b01101011, (byte) 0b11100010, 0b00111001, 0b01010101, 0b00001111,
                    0b01110000, 0b00100110};
            Image picture = new Image(8, 8, before.clone());
            picture.getGraphics().copyArea(2, 2, 4, 4, 2 + dx, 2 + dy, 0);
            for (int y = 0; y < 4; y++) {
                for (int x = 0; x < 4; x++) {
                    assertThat(picture.getData()[2 + dy + y] >> 2 + dx + x & 1).as("index " + index)
                            .isEqualTo(before[2 + y] >> 2 + x & 1);
                }
            }
        }
    }
}
