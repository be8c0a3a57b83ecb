package lejos.internal.ev3;

import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.TextLCD;

/** A layer of the screen as a grid of characters. */
public class EV3TextLCD extends EV3LCD implements TextLCD {
    private final Font font;
    private final int columns;
    private final int rows;

    /** The named layer in the given font. */
    public EV3TextLCD(String layerName, Font f) {
        super(layerName);
        font = f;
        columns = SCREEN_WIDTH / f.width;
        rows = SCREEN_HEIGHT / f.height;
    }

    /** The named layer in the default font. */
    public EV3TextLCD(String layerName) {
        this(layerName, Font.getDefaultFont());
    }

    @Override
    public void drawChar(char c, int x, int y) {
        spend(font.width * font.height);
        if (hasGlyph(c)) {
            drawGlyph(c, x, y, ROP_COPY);
        }
    }

    @Override
    public void drawString(String str, int x, int y) {
        drawString(str, x, y, false);
    }

    @Override
    public void drawString(String str, int x, int y, boolean inverted) {
        spend(str.length() * font.width * font.height);
        fill(x * font.width, y * font.height, str.length() * font.width, font.height, inverted ? ROP_SET : ROP_CLEAR);
        for (int i = 0; i < str.length(); i++) {
            if (hasGlyph(str.charAt(i))) {
                drawGlyph(str.charAt(i), x + i, y, inverted ? ROP_COPYINVERTED : ROP_COPY);
            }
        }
    }

    private boolean hasGlyph(char c) {
        return c >= font.firstChar && c < font.firstChar + font.glyphCount;
    }

    private void drawGlyph(char c, int x, int y, int rop) {
        RasterOperation.bitBlt(font.glyphs, font.glyphWidth * font.glyphCount, font.height,
                font.glyphWidth * (c - font.firstChar), 0,
                displayBuf, SCREEN_WIDTH, SCREEN_HEIGHT, x * font.width, y * font.height, font.width, font.height, rop);
    }

    @Override
    public void drawInt(int i, int x, int y) {
        drawString(Integer.toString(i), x, y);
    }

    @Override
    public void drawInt(int i, int places, int x, int y) {
        drawString(String.format("%" + places + "d", i), x, y);
    }

    @Override
    public void scroll() {
        int kept = (rows - 1) * font.height;
        bitBlt(displayBuf, SCREEN_WIDTH, SCREEN_HEIGHT, 0, font.height, 0, 0, SCREEN_WIDTH, kept, ROP_COPY);
        fill(0, kept, SCREEN_WIDTH, SCREEN_HEIGHT - kept, ROP_CLEAR);
    }

    @Override
    public void clear(int x, int y, int n) {
        fill(x * font.width, y * font.height, n * font.width, font.height, ROP_CLEAR);
    }

    @Override
    public void clear(int y) {
        fill(0, y * font.height, SCREEN_WIDTH, font.height, ROP_CLEAR);
    }

    @Override
    public Font getFont() {
        return font;
    }

    @Override
    public int getTextWidth() {
        return columns;
    }

    @Override
    public int getTextHeight() {
        return rows;
    }
}
