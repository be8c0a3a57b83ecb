package brickless.device.panel;

import brickless.hardware.ScreenFont;
import brickless.hardware.ScreenSocket;
import java.util.HashMap;
import java.util.Map;

/**
 * Reads text back from a picture of the screen, for tests and logs. The screen is taken as the text grid of one font; a
 * cell that holds anything else than a character of that font reads as {@value #UNKNOWN}.
 */
public final class ScreenText {
    /** Stands for a cell that is no character. */
    public static final char UNKNOWN = '\u00bf';

    private static final ScreenText MEDIUM = new ScreenText(ScreenFont.medium());
    private static final ScreenText SMALL = new ScreenText(ScreenFont.small());

    private final ScreenFont font;
    private final Map<String, Character> characters = new HashMap<>();

    private ScreenText(ScreenFont font) {
        this.font = font;
        for (int i = 0; i < ScreenFont.CHARACTERS; i++) {
            char character = (char) (ScreenFont.FIRST_CHARACTER + i);
            characters.putIfAbsent(inkOf(character), character);
        }
    }

    /** The lines in the medium font (8 rows of 17 columns), trailing blanks and trailing blank lines removed. */
    public static String read(byte[] picture) {
        return MEDIUM.lines(picture);
    }

    /** The lines in the small font (16 rows of 29 columns), trailing blanks and trailing blank lines removed. */
    public static String readSmall(byte[] picture) {
        return SMALL.lines(picture);
    }

    private String lines(byte[] picture) {
        StringBuilder text = new StringBuilder();
        for (int row = 0; row < ScreenSocket.HEIGHT / font.height(); row++) {
            StringBuilder line = new StringBuilder();
            for (int column = 0; column < ScreenSocket.WIDTH / font.width(); column++) {
                line.append(characters.getOrDefault(inkAt(picture, column, row), UNKNOWN));
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString().stripTrailing();
    }

    private String inkOf(char character) {
        StringBuilder cell = new StringBuilder();
        for (int y = 0; y < font.height(); y++) {
            for (int x = 0; x < font.width(); x++) {
                cell.append(font.ink(character, x, y) ? '#' : '.');
            }
        }
        return cell.toString();
    }

    private String inkAt(byte[] picture, int column, int row) {
        StringBuilder cell = new StringBuilder();
        for (int y = row * font.height(); y < (row + 1) * font.height(); y++) {
            for (int x = column * font.width(); x < (column + 1) * font.width(); x++) {
                boolean ink = (picture[y * ScreenSocket.ROW_BYTES + (x >> 3)] >> (x & 7) & 1) != 0;
                cell.append(ink ? '#' : '.');
            }
        }
        return cell.toString();
    }
}
