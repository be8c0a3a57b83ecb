package lejos.hardware.lcd;

/** A display as a grid of characters of one font: x is the column, y the row, both from 0. */
public interface TextLCD extends CommonLCD {
    /** Draws a character over its cell; characters outside 32 to 127 leave the cell unchanged. */
    void drawChar(char c, int x, int y);

    /**
     * Draws text over its cells, clipped at the right edge; there is no wrapping, and characters outside 32 to 127 are
     * blank.
     *
     * @param inverted white text on black if true
     */
    void drawString(String str, int x, int y, boolean inverted);

    /**
     * Draws text over its cells, clipped at the right edge; there is no wrapping, and characters outside 32 to 127 are
     * blank.
     */
    void drawString(String str, int x, int y);

    /** Draws a decimal number. */
    void drawInt(int i, int x, int y);

    /**
     * Draws a decimal number right-aligned, padded with blanks; longer numbers are not cut.
     *
     * @param places least number of characters, above 0
     * @throws java.util.MissingFormatWidthException if {@code places} is 0
     */
    void drawInt(int i, int places, int x, int y);

    /** Clears {@code n} cells from column {@code x} of row {@code y}. */
    void clear(int x, int y, int n);

    /** Clears a row. */
    void clear(int y);

    /** Moves everything up by a row; the last row becomes blank. */
    void scroll();

    /** The font of the grid. */
    Font getFont();

    /** Number of columns. */
    int getTextWidth();

    /** Number of rows. */
    int getTextHeight();
}
