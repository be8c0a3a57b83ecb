package brickless.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Samples a square of the floor: 32 by 32 points, half a millimetre apart. Immutable. */
final class TilePainter {
    static final int SIDE = 32;
    static final double TILE_METRES = SIDE * Floor.SAMPLE_METRES;
    private static final int[] WHITE_TILE = {0xFFFFFF};

    private record Layer(Paint paint, RegionRaster raster, double[] bounds) {}

    private final double minX;
    private final double minY;
    private final List<Layer> layers = new ArrayList<>();
    private final RegionRaster table;

    TilePainter(World world) {
        this.minX = world.minX();
        this.minY = world.minY();
        for (Paint paint : world.floor()) {
            layers.add(new Layer(paint, RegionRaster.of(paint.region()), paint.region().bounds()));
        }
        this.table = world.table().map(RegionRaster::of).orElse(null);
    }

    /** Colours row by row, or a single value if all are equal. */
    int[] paint(int column, int row) {
        double x = minX + column * TILE_METRES;
        double y = minY + row * TILE_METRES;
        double[] rgb = null;
        boolean[] covered = new boolean[SIDE * SIDE];
        for (Layer layer : layers) {
            double[] box = layer.bounds();
            if (box[0] > x + TILE_METRES || box[2] < x || box[1] > y + TILE_METRES || box[3] < y) {
                continue;
            }
            if (rgb == null) {
                rgb = new double[3 * SIDE * SIDE];
                Arrays.fill(rgb, 255);
            }
            layer.raster().cover(x, y, covered);
            blend(layer.paint(), x, y, covered, rgb);
        }
        if (rgb == null && table == null) {
            return WHITE_TILE;
        }
        int[] tile = packed(rgb);
        if (table != null) {
            table.cover(x, y, covered);
            for (int i = 0; i < covered.length; i++) {
                tile[i] = covered[i] ? tile[i] : Floor.NO_FLOOR;
            }
        }
        return compact(tile);
    }

    private static void blend(Paint paint, double x, double y, boolean[] covered, double[] rgb) {
        Texture texture = paint.texture().orElse(null);
        int flat = paint.colour().red() << 16 | paint.colour().green() << 8 | paint.colour().blue();
        for (int i = 0; i < covered.length; i++) {
            if (covered[i]) {
                int argb = texture == null ? flat : texture.argbAt(centre(x, i % SIDE), centre(y, i / SIDE));
                double opacity = texture == null ? paint.opacity() : paint.opacity() * (argb >>> 24) / 255;
                rgb[3 * i] += ((argb >> 16 & 255) - rgb[3 * i]) * opacity;
                rgb[3 * i + 1] += ((argb >> 8 & 255) - rgb[3 * i + 1]) * opacity;
                rgb[3 * i + 2] += ((argb & 255) - rgb[3 * i + 2]) * opacity;
            }
        }
    }

    /** Coordinate of the middle of the n-th sample. */
    static double centre(double start, int n) {
        return start + (n + 0.5) * Floor.SAMPLE_METRES;
    }

    private static int[] packed(double[] rgb) {
        int[] tile = new int[SIDE * SIDE];
        for (int i = 0; i < tile.length; i++) {
            tile[i] = rgb == null ? 0xFFFFFF
                    : component(rgb[3 * i]) << 16 | component(rgb[3 * i + 1]) << 8 | component(rgb[3 * i + 2]);
        }
        return tile;
    }

    private static int component(double value) {
        return (int) Math.max(0, Math.min(255, value + 0.5));
    }

    private static int[] compact(int[] tile) {
        for (int colour : tile) {
            if (colour != tile[0]) {
                return tile;
            }
        }
        return new int[] {tile[0]};
    }
}
