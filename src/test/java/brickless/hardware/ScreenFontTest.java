package brickless.hardware;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ScreenFontTest {
    private static final List<ScreenFont> FONTS = List.of(ScreenFont.small(), ScreenFont.medium(), ScreenFont.large());

    private static String cell(ScreenFont font, char character) {
        StringBuilder cell = new StringBuilder();
        for (int y = 0; y < font.height(); y++) {
            for (int x = 0; x < font.width(); x++) {
                cell.append(font.ink(character, x, y) ? '#' : '.');
            }
            cell.append('\n');
        }
        return cell.toString();
    }

    @Test
    void allCharactersOfAFontDiffer() {
        for (ScreenFont font : FONTS) {
            Set<String> cells = new HashSet<>();
            for (char c = 32; c < 128; c++) {
                assertThat(cells.add(cell(font, c))).as("character " + c + " at height " + font.height()).isTrue();
            }
        }
    }

    @Test
    void blankIsBlankAndUncoveredCharactersHaveNoInk() {
        for (ScreenFont font : FONTS) {
            assertThat(cell(font, ' ')).doesNotContain("#");
            assertThat(cell(font, '\u00e9')).doesNotContain("#");
            assertThat(cell(font, '\n')).doesNotContain("#");
        }
    }

    @Test
    void lettersStandOnTheBaseline() {
        for (ScreenFont font : FONTS) {
            for (char c : "ABCDEHIKLMNRXZabcdehiklmnorx".toCharArray()) {
                String[] rows = cell(font, c).split("\n");
                assertThat(rows[font.baseline() - 1]).as("last row of " + c).contains("#");
                assertThat(rows[font.baseline()]).as("row below " + c).doesNotContain("#");
            }
        }
    }

    @Test
    void lettersOfTheMediumFontLeaveTheOuterColumnsFree() {
        for (char c = 'A'; c <= 'z'; c++) {
            if (Character.isLetter(c)) {
                for (String row : cell(ScreenFont.medium(), c).split("\n")) {
                    assertThat(row).as("row of " + c).matches("\\..{8}\\.");
                }
            }
        }
    }

    @Test
    void largeFontIsTheMediumOneDoubledWithSmoothedDiagonals() {
        assertThat(cell(ScreenFont.large(), '-').replace("\n", "").chars().filter(c -> c == '#').count())
                .as("twelve pixels become four each, the four corners are rounded off").isEqualTo(12 * 4 - 4);
        BitGrid step = new BitGrid(2, 2);
        step.set(0, 0);
        step.set(1, 1);
        BitGrid doubled = step.doubled(2);
        assertThat(doubled.get(1, 2) && doubled.get(2, 1)).as("the corner is filled").isTrue();
        assertThat(doubled.get(3, 0) || doubled.get(0, 3)).isFalse();
    }

    @Test
    void stripHasTheBitOrderOfTheScreen() {
        ScreenFont font = ScreenFont.medium();
        byte[] strip = font.glyphs();
        assertThat(strip).hasSize(120 * 16);
        int column = ('L' - 32) * 10 + 1;
        assertThat(strip[5 * 120 + column / 8] >> column % 8 & 1).as("stem of L").isOne();
    }
}
