package lejos.internal.ev3;

import java.util.ArrayList;
import java.util.List;

/**
 * The upper left quarter of the outline of an ellipse in a box of {@code width + 1} by {@code height + 1} pixels, as
 * steps from the middle of the top to the middle of the left side. The other quarters are its mirror images.
 */
final class EllipseOutline {
    private final int width;
    private final int height;
    private final List<int[]> quarter = new ArrayList<>();
    private final int[] leftmost;

    /** The outline for a box; both sizes 0 or more. */
    EllipseOutline(int width, int height) {
        this.width = width;
        this.height = height;
        this.leftmost = new int[height / 2 + 1];
        walk();
    }

    /** Pixels of the quarter, from the box's upper left corner. */
    List<int[]> quarter() {
        return quarter;
    }

    /**
     * First column of the ellipse in a row of the box, from the box's left edge; the last column is as far from the
     * right edge.
     */
    int leftmost(int row) {
        return leftmost[Math.min(row, height - row)];
    }

    /** Goes left, down or both, whichever stays closest to the ellipse. */
    private void walk() {
        int x = width / 2;
        int y = 0;
        add(x, y);
        while (x > 0 || y < height / 2) {
            boolean mayGoLeft = x > 0;
            boolean mayGoDown = y < height / 2;
            long left = mayGoLeft ? deviation(x - 1, y) : Long.MAX_VALUE;
            long down = mayGoDown ? deviation(x, y + 1) : Long.MAX_VALUE;
            long both = mayGoLeft && mayGoDown ? deviation(x - 1, y + 1) : Long.MAX_VALUE;
            if (both <= left && both <= down) {
                x--;
                y++;
            } else if (left <= down) {
                x--;
            } else {
                y++;
            }
            add(x, y);
        }
    }

    private void add(int x, int y) {
        quarter.add(new int[] {x, y});
        leftmost[y] = x;
    }

    /** How far a pixel is off the ellipse: |X²h² + Y²w² − w²h²| with X and Y from the centre in half pixels. */
    private long deviation(int x, int y) {
        long fromCentreX = 2L * x - width;
        long fromCentreY = 2L * y - height;
        long w2 = (long) width * width;
        long h2 = (long) height * height;
        return Math.abs(fromCentreX * fromCentreX * h2 + fromCentreY * fromCentreY * w2 - w2 * h2);
    }
}
