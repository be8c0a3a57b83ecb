package lejos.internal.ev3;

import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.Image;

/** Draws shapes, images and text on a layer of the screen or on a picture. */
public class EV3GraphicsLCD extends EV3LCD implements GraphicsLCD {
    private static final int COLOUR_MAX = 255;

    private final Pen pen = new Pen(this);
    private int rgb = BLACK;
    private Font font = Font.getDefaultFont();
    private int translateX;
    private int translateY;

    /** Draws on the named layer of the screen. */
    public EV3GraphicsLCD(String layerName) {
        super(layerName);
    }

    /** Draws on a picture: rows of whole bytes, lowest bit leftmost. */
    public EV3GraphicsLCD(byte[] data, int width, int height) {
        super(data, width, height);
    }

    // ---- text

    @Override
    public void drawString(String str, int x, int y, int anchor) {
        int ink = rgb == BLACK ? ROP_OR : ROP_ANDINVERTED;
        drawText(str, textLeft(str, x, anchor), textTop(y, anchor), ink);
    }

    @Override
    public void drawString(String str, int x, int y, int anchor, boolean inverted) {
        if (!inverted) {
            drawString(str, x, y, anchor);
            return;
        }
        int left = textLeft(str, x, anchor);
        int top = textTop(y, anchor);
        fill(left, top, font.stringWidth(str), font.height, rgb == BLACK ? ROP_SET : ROP_CLEAR);
        drawText(str, left, top, rgb == BLACK ? ROP_ANDINVERTED : ROP_OR);
    }

    private int textLeft(String str, int x, int anchor) {
        return Anchor.left(x, font.stringWidth(str), anchor) + translateX;
    }

    private int textTop(int y, int anchor) {
        return Anchor.topOfText(y, font.height, font.base, anchor) + translateY;
    }

    private void drawText(String str, int left, int top, int rop) {
        spend(str.length() * font.width * font.height);
        for (int i = 0; i < str.length(); i++) {
            int glyph = str.charAt(i) - font.firstChar;
            if (glyph >= 0 && glyph < font.glyphCount) {
                RasterOperation.bitBlt(font.glyphs, font.glyphWidth * font.glyphCount, font.height,
                        font.glyphWidth * glyph, 0,
                        displayBuf, getWidth(), getHeight(), left + i * font.width, top, font.width, font.height, rop);
            }
        }
    }

    @Override
    public void drawSubstring(String str, int offset, int len, int x, int y, int anchor) {
        if (offset < 0 || len < 0 || offset + len > str.length()) {
            throw new StringIndexOutOfBoundsException();
        }
        drawString(str.substring(offset, offset + len), x, y, anchor);
    }

    @Override
    public void drawChar(char character, int x, int y, int anchor) {
        drawString(String.valueOf(character), x, y, anchor);
    }

    @Override
    public void drawChars(char[] data, int offset, int length, int x, int y, int anchor) {
        if (offset < 0 || length < 0 || offset + length > data.length) {
            throw new ArrayIndexOutOfBoundsException();
        }
        drawString(new String(data, offset, length), x, y, anchor);
    }

    @Override
    public Font getFont() {
        return font;
    }

    @Override
    public void setFont(Font f) {
        font = f;
    }

    // ---- images

    @Override
    public void drawRegionRop(Image src, int sx, int sy, int w, int h, int x, int y, int anchor, int rop) {
        drawRegionRop(src, sx, sy, w, h, TRANS_NONE, x, y, anchor, rop);
    }

    @Override
    public void drawRegionRop(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor,
            int rop) {
        Image picture = src == null ? new Image(getWidth(), getHeight(), displayBuf) : src;
        if (transform == TRANS_NONE) {
            blit(picture, sx, sy, w, h, x, y, anchor, rop);
        } else {
            Image turned = PixelCopy.of(picture.getData(), picture.getWidth(), picture.getHeight(), sx, sy, w, h,
                    transform);
            blit(turned, 0, 0, turned.getWidth(), turned.getHeight(), x, y, anchor, rop);
        }
    }

    private void blit(Image picture, int sx, int sy, int w, int h, int x, int y, int anchor, int rop) {
        bitBlt(picture.getData(), picture.getWidth(), picture.getHeight(), sx, sy,
                Anchor.left(x, w, anchor) + translateX, Anchor.topOfImage(y, h, anchor) + translateY, w, h, rop);
    }

    @Override
    public void drawRegion(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor) {
        drawRegionRop(src, sx, sy, w, h, transform, x, y, anchor, ROP_COPY);
    }

    @Override
    public void drawImage(Image src, int x, int y, int anchor) {
        drawRegion(src, 0, 0, src.getWidth(), src.getHeight(), TRANS_NONE, x, y, anchor);
    }

    @Override
    public void copyArea(int sx, int sy, int w, int h, int x, int y, int anchor) {
        drawRegionRop(null, sx + translateX, sy + translateY, w, h, x, y, anchor, ROP_COPY);
    }

    // ---- shapes

    @Override
    public void drawLine(int x0, int y0, int x1, int y1) {
        pen.line(x0 + translateX, y0 + translateY, x1 + translateX, y1 + translateY);
    }

    @Override
    public void drawArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
        if (width >= 0 && height >= 0) {
            pen.arc(x + translateX, y + translateY, width, height, new ArcSector(width, height, startAngle, arcAngle));
        }
    }

    @Override
    public void fillArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
        if (width >= 0 && height >= 0) {
            pen.fillSector(x + translateX, y + translateY, width, height,
                    new ArcSector(width, height, startAngle, arcAngle));
        }
    }

    @Override
    public void drawRoundRect(int x, int y, int width, int height, int arcWidth, int arcHeight) {
        if (width >= 0 && height >= 0) {
            int roundedWidth = Math.max(0, Math.min(width, arcWidth));
            int roundedHeight = Math.max(0, Math.min(height, arcHeight));
            pen.roundRectangle(x + translateX, y + translateY, width, height,
                    new EllipseOutline(roundedWidth, roundedHeight));
        }
    }

    @Override
    public void drawRect(int x, int y, int width, int height) {
        if (width >= 0 && height >= 0) {
            pen.rectangle(x + translateX, y + translateY, width, height);
        }
    }

    @Override
    public void fillRect(int x, int y, int width, int height) {
        if (width > 0 && height > 0) {
            fill(x + translateX, y + translateY, width, height, rgb == BLACK ? ROP_SET : ROP_CLEAR);
        }
    }

    // ---- state

    @Override
    public int getStrokeStyle() {
        return pen.style();
    }

    @Override
    public void setStrokeStyle(int style) {
        if (style != SOLID && style != DOTTED) {
            throw new IllegalArgumentException();
        }
        pen.setStyle(style);
    }

    /** The pixel value of a colour: 1 for black, 0 for everything else. */
    public int getDisplayColor(int rgb) {
        return rgb == BLACK ? 1 : 0;
    }

    @Override
    public void setColor(int rgb) {
        this.rgb = rgb & WHITE;
    }

    @Override
    public void setColor(int red, int green, int blue) {
        if ((red | green | blue) < 0 || red > COLOUR_MAX || green > COLOUR_MAX || blue > COLOUR_MAX) {
            throw new IllegalArgumentException("bad color value");
        }
        setColor(red << 16 | green << 8 | blue);
    }

    /** The colour as 0xrrggbb. */
    public int getColor() {
        return rgb;
    }

    /** Red part of the colour, 0 to 255. */
    public int getRedComponent() {
        return rgb >> 16 & COLOUR_MAX;
    }

    /** Green part of the colour, 0 to 255. */
    public int getGreenComponent() {
        return rgb >> 8 & COLOUR_MAX;
    }

    /** Blue part of the colour, 0 to 255. */
    public synchronized int getBlueComponent() {
        return rgb & COLOUR_MAX;
    }

    @Override
    public synchronized void translate(int x, int y) {
        translateX += x;
        translateY += y;
    }

    @Override
    public synchronized int getTranslateX() {
        return translateX;
    }

    @Override
    public synchronized int getTranslateY() {
        return translateY;
    }

    @Override
    public int getWidth() {
        return super.getWidth();
    }

    @Override
    public int getHeight() {
        return super.getHeight();
    }

    @Override
    public void clear() {
        super.clear();
    }
}
