package brickless.hardware;

/**
 * A fixed-width font of the brick's screen: the characters 32 to 127 as one strip of 96 cells.
 *
 * <p>The small and the medium font are drawn in text files beside this class; the large one is the medium font doubled
 * with smoothed diagonals. Immutable and shared by all robots.
 */
public final class ScreenFont {
    /** First character of the strip. */
    public static final int FIRST_CHARACTER = 32;
    /** Number of characters in the strip. */
    public static final int CHARACTERS = 96;

    private final BitGrid strip;
    private final int width;
    private final int baseline;

    private ScreenFont(BitGrid strip, int baseline) {
        this.strip = strip;
        this.width = strip.width() / CHARACTERS;
        this.baseline = baseline;
    }

    /** The font of 6 × 8 pixels. */
    public static ScreenFont small() {
        return Sizes.SMALL;
    }

    /** The font of 10 × 16 pixels, the default. */
    public static ScreenFont medium() {
        return Sizes.MEDIUM;
    }

    /** The font of 20 × 32 pixels. */
    public static ScreenFont large() {
        return Sizes.LARGE;
    }

    /** Width of a cell in pixels. */
    public int width() {
        return width;
    }

    /** Height of a cell in pixels. */
    public int height() {
        return strip.height();
    }

    /** Distance of the baseline from the top of the cell in pixels; the first row below the letters. */
    public int baseline() {
        return baseline;
    }

    /** Whether the font has a picture of the character. */
    public static boolean covers(char character) {
        return character >= FIRST_CHARACTER && character < FIRST_CHARACTER + CHARACTERS;
    }

    /** Whether a pixel of a character's cell is black; false for characters the font does not cover. */
    public boolean ink(char character, int x, int y) {
        return covers(character) && strip.get((character - FIRST_CHARACTER) * width + x, y);
    }

    /** A copy of the strip: row by row, {@code 12 × width} bytes each, lowest bit leftmost, 1 = black. */
    public byte[] glyphs() {
        return strip.toBytes();
    }

    /** Read on first use, because most programs use one font. */
    private static final class Sizes {
        static final ScreenFont SMALL = new ScreenFont(FontSheet.read("font-6x8.txt", 6, 8), 7);
        static final ScreenFont MEDIUM = new ScreenFont(FontSheet.read("font-10x16.txt", 10, 16), 14);
        static final ScreenFont LARGE = new ScreenFont(MEDIUM.strip.doubled(MEDIUM.width), 28);
    }
}
