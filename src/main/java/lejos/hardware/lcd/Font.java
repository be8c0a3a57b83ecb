package lejos.hardware.lcd;

import brickless.hardware.ScreenFont;
import java.io.Serializable;

/** A font of fixed width: a strip image with one glyph after the other. */
public class Font implements Serializable {
    /** Size of the small font, 6 × 8 pixels. */
    public static final int SIZE_SMALL = 8;
    /** Size of the default font, 10 × 16 pixels. */
    public static final int SIZE_MEDIUM = 0;
    /** Size of the large font, 20 × 32 pixels. */
    public static final int SIZE_LARGE = 16;

    private static final long serialVersionUID = 1L;

    /** Width of a character cell in pixels. */
    public final int width;
    /** Height of a character cell in pixels. */
    public final int height;
    /** Width of a glyph in the strip in pixels. */
    public final int glyphWidth;
    /** Number of glyphs in the strip. */
    public final int glyphCount;
    /** Character of the first glyph. */
    public final int firstChar;
    /** Row of the baseline, counted from the top of the cell. */
    public final int base;
    /** The strip: {@code height} rows of {@code glyphCount × glyphWidth} pixels, lowest bit leftmost. */
    public final byte[] glyphs;

    /**
     * A font from its strip image.
     *
     * @param glyphs the strip
     * @param width width of a cell in pixels
     * @param height height of a cell in pixels
     * @param base row of the baseline
     * @param glyphWidth width of a glyph in pixels
     * @param glyphCount number of glyphs
     * @param first character of the first glyph
     */
    protected Font(byte[] glyphs, int width, int height, int base, int glyphWidth, int glyphCount, int first) {
        this.glyphs = glyphs;
        this.width = width;
        this.height = height;
        this.base = base;
        this.glyphWidth = glyphWidth;
        this.glyphCount = glyphCount;
        this.firstChar = first;
    }

    private static Font of(ScreenFont font) {
        return new Font(font.glyphs(), font.width(), font.height(), font.baseline(), font.width(),
                ScreenFont.CHARACTERS, ScreenFont.FIRST_CHARACTER);
    }

    /** The font of 10 × 16 pixels: 17 columns and 8 rows. */
    public static Font getDefaultFont() {
        return Medium.FONT;
    }

    /** Height of a line in pixels. */
    public int getHeight() {
        return height;
    }

    /** Distance of the baseline from the top of a line in pixels. */
    public int getBaselinePosition() {
        return base;
    }

    /** Width of a text in pixels. */
    public int stringWidth(String str) {
        return str.length() * width;
    }

    /**
     * A font by size.
     *
     * @param face ignored
     * @param style ignored
     * @param size {@link #SIZE_SMALL}, {@link #SIZE_LARGE}, or the default font for anything else
     */
    public static Font getFont(int face, int style, int size) {
        return switch (size) {
            case SIZE_SMALL -> getSmallFont();
            case SIZE_LARGE -> getLargeFont();
            default -> getDefaultFont();
        };
    }

    /** The font of 6 × 8 pixels: 29 columns and 16 rows. */
    public static synchronized Font getSmallFont() {
        return Small.FONT;
    }

    /** The font of 20 × 32 pixels: 8 columns and 4 rows. */
    public static synchronized Font getLargeFont() {
        return Large.FONT;
    }

    private static final class Small {
        static final Font FONT = of(ScreenFont.small());
    }

    private static final class Medium {
        static final Font FONT = of(ScreenFont.medium());
    }

    private static final class Large {
        static final Font FONT = of(ScreenFont.large());
    }
}
