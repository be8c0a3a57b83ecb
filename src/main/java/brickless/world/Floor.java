package brickless.world;

import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * The painted floor of a world, for sensors that look at it again and again. The drawing is sampled every half
 * millimetre, tile by tile, at first need; paint lies on white, transparent paint mixes with what is below. Only
 * comparisons and basic arithmetic are used, so every machine sees the same floor.
 *
 * <p>Safe for all threads: a tile is computed from immutable data, and computing it twice gives the same tile.
 */
public final class Floor {
    /** Distance between samples, metres: fine against the 10 mm spot of a colour sensor. */
    public static final double SAMPLE_METRES = 0.0005;
    /** What {@link #rgbAt} returns where there is no floor. */
    public static final int NO_FLOOR = -1;
    private static final int WHITE = 0xFFFFFF;

    private final World world;
    private final TilePainter painter;
    private final int columns;
    private final int rows;
    private final AtomicReferenceArray<int[]> tiles;

    /** The floor of a world; cheap until it is looked at. */
    public Floor(World world) {
        this.world = world;
        this.painter = new TilePainter(world);
        this.columns = 1 + (int) Math.floor(world.width() / TilePainter.TILE_METRES);
        this.rows = 1 + (int) Math.floor(world.height() / TilePainter.TILE_METRES);
        this.tiles = new AtomicReferenceArray<>(Math.multiplyExact(columns, rows));
    }

    /**
     * Colour of a point, metres.
     *
     * @return sRGB as {@code 0xRRGGBB}, or {@link #NO_FLOOR} outside the table; off the drawing the floor is white
     */
    public int rgbAt(double x, double y) {
        double right = x - world.minX();
        double down = y - world.minY();
        if (!(right >= 0 && right < world.width() && down >= 0 && down < world.height())) {
            return world.table().isEmpty() || world.table().get().contains(x, y) ? WHITE : NO_FLOOR;
        }
        int column = (int) (right / TilePainter.TILE_METRES);
        int row = (int) (down / TilePainter.TILE_METRES);
        int[] tile = tile(column, row);
        if (tile.length == 1) {
            return tile[0];
        }
        int px = Math.min(TilePainter.SIDE - 1, (int) (right / SAMPLE_METRES) - column * TilePainter.SIDE);
        int py = Math.min(TilePainter.SIDE - 1, (int) (down / SAMPLE_METRES) - row * TilePainter.SIDE);
        return tile[Math.max(0, py) * TilePainter.SIDE + Math.max(0, px)];
    }

    /** Colour of a point, metres; black where there is no floor. */
    public Rgb colourAt(double x, double y) {
        int rgb = rgbAt(x, y);
        return rgb == NO_FLOOR ? new Rgb(0, 0, 0) : new Rgb(rgb >> 16, rgb >> 8 & 255, rgb & 255);
    }

    /**
     * Mean colour of a round spot: the mean of the drawn components at 19 points, one in the middle, six on a ring at
     * 0.459 and twelve on a ring at 0.827 of the radius, so that each stands for the same area. Missing floor counts
     * as black.
     */
    public Rgb average(double x, double y, double radiusMetres) {
        int red = 0;
        int green = 0;
        int blue = 0;
        for (int i = 0; i < SpotPattern.POINTS; i++) {
            int rgb = rgbAt(x + SpotPattern.x(i) * radiusMetres, y + SpotPattern.y(i) * radiusMetres);
            if (rgb != NO_FLOOR) {
                red += rgb >> 16;
                green += rgb >> 8 & 255;
                blue += rgb & 255;
            }
        }
        return new Rgb(mean(red), mean(green), mean(blue));
    }

    private static int mean(int sum) {
        return (2 * sum + SpotPattern.POINTS) / (2 * SpotPattern.POINTS);
    }

    private int[] tile(int column, int row) {
        int index = row * columns + column;
        int[] tile = tiles.get(index);
        if (tile == null) {
            tile = painter.paint(column, row);
            tiles.set(index, tile);
        }
        return tile;
    }
}
