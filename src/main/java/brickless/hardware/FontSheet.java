package brickless.hardware;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads a font drawn as text: blocks of rows, each row holding the same row of several glyphs side by side, {@code #}
 * for ink. Lines that start with {@code %} are comments.
 */
final class FontSheet {
    private FontSheet() {}

    /** Reads a resource beside this class into one strip of 96 cells. */
    static BitGrid read(String resource, int cellWidth, int cellHeight) {
        List<String> rows = rows(resource);
        BitGrid strip = new BitGrid(ScreenFont.CHARACTERS * cellWidth, cellHeight);
        int glyph = 0;
        for (int top = 0; top < rows.size(); top += cellHeight) {
            int glyphs = rows.get(top).split(" ").length;
            for (int y = 0; y < cellHeight; y++) {
                copyRow(rows.get(top + y).replace(" ", ""), strip, glyph * cellWidth, y);
            }
            glyph += glyphs;
        }
        if (glyph != ScreenFont.CHARACTERS) {
            throw new IllegalStateException(resource + " holds " + glyph + " glyphs instead of "
                    + ScreenFont.CHARACTERS);
        }
        return strip;
    }

    private static void copyRow(String row, BitGrid strip, int left, int y) {
        for (int x = 0; x < row.length(); x++) {
            if (row.charAt(x) == '#') {
                strip.set(left + x, y);
            }
        }
    }

    private static List<String> rows(String resource) {
        List<String> rows = new ArrayList<>();
        try (InputStream stream = FontSheet.class.getResourceAsStream(resource)) {
            if (stream == null) {
                throw new IllegalStateException("missing resource " + resource);
            }
            BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.US_ASCII));
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                if (!line.isBlank() && !line.startsWith("%")) {
                    rows.add(line.strip());
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return rows;
    }
}
