package lejos.internal.ev3;

import lejos.hardware.lcd.GraphicsLCD;

/**
 * Draws outlines pixel by pixel on a surface, solid or dotted, in the surface's colour. Coordinates are untranslated.
 */
final class Pen {
    private final EV3GraphicsLCD surface;
    private int style = GraphicsLCD.SOLID;

    Pen(EV3GraphicsLCD surface) {
        this.surface = surface;
    }

    int style() {
        return style;
    }

    void setStyle(int newStyle) {
        style = newStyle;
    }

    /**
     * A line with both ends, by Bresenham's rule; dotted lines show the start, the next pixel, and every second pixel
     * after it.
     */
    void line(int x0, int y0, int x1, int y1) {
        int dx = Math.abs(x1 - x0);
        int dy = Math.abs(y1 - y0);
        int stepX = Integer.compare(x1, x0);
        int stepY = Integer.compare(y1, y0);
        int length = Math.max(dx, dy);
        int minor = Math.min(dx, dy);
        surface.spend(length + 1);
        int error = 2 * minor - length;
        int x = x0;
        int y = y0;
        for (int i = 0; i <= length; i++) {
            dot(i, x, y);
            boolean sidestep = error >= 0;
            error += 2 * minor - (sidestep ? 2 * length : 0);
            x += dx >= dy || sidestep ? stepX : 0;
            y += dx < dy || sidestep ? stepY : 0;
        }
    }

    /** The sides one after the other, clockwise from the upper left corner. */
    void rectangle(int x, int y, int width, int height) {
        if (width == 0 || height == 0) {
            line(x, y, x + width, y + height);
            return;
        }
        line(x, y, x + width, y);
        line(x + width, y, x + width, y + height);
        line(x + width, y + height, x, y + height);
        line(x, y + height, x, y);
    }

    void arc(int x, int y, int width, int height, ArcSector sector) {
        EllipseOutline outline = new EllipseOutline(width, height);
        surface.spend(4 * outline.quarter().size());
        int i = 0;
        for (int[] pixel : outline.quarter()) {
            for (int column : new int[] {pixel[0], width - pixel[0]}) {
                for (int row : new int[] {pixel[1], height - pixel[1]}) {
                    if (sector.contains(column, row)) {
                        dot(i, x + column, y + row);
                    }
                }
            }
            i++;
        }
    }

    void fillSector(int x, int y, int width, int height, ArcSector sector) {
        EllipseOutline outline = new EllipseOutline(width, height);
        surface.spend((width + 1) * (height + 1));
        for (int row = 0; row <= height; row++) {
            for (int column = outline.leftmost(row); column <= width - outline.leftmost(row); column++) {
                if (sector.contains(column, row)) {
                    surface.plot(x + column, y + row, black());
                }
            }
        }
    }

    /** A rectangle whose corners are the quarters of an ellipse. */
    void roundRectangle(int x, int y, int width, int height, EllipseOutline corner) {
        int[] top = corner.quarter().get(0);
        int[] side = corner.quarter().get(corner.quarter().size() - 1);
        line(x + top[0], y, x + width - top[0], y);
        line(x + top[0], y + height, x + width - top[0], y + height);
        line(x, y + side[1], x, y + height - side[1]);
        line(x + width, y + side[1], x + width, y + height - side[1]);
        int i = 0;
        for (int[] pixel : corner.quarter()) {
            dot(i, x + pixel[0], y + pixel[1]);
            dot(i, x + width - pixel[0], y + pixel[1]);
            dot(i, x + pixel[0], y + height - pixel[1]);
            dot(i, x + width - pixel[0], y + height - pixel[1]);
            i++;
        }
    }

    private void dot(int index, int x, int y) {
        if (style == GraphicsLCD.SOLID || index == 0 || index % 2 == 1) {
            surface.plot(x, y, black());
        }
    }

    private boolean black() {
        return surface.getColor() == GraphicsLCD.BLACK;
    }
}
