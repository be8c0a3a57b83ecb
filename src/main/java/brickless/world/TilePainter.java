package brickless.world;

import java.util.ArrayList;
import java.util.List;

/** Samples a square of the floor: 32 by 32 points, half a millimetre apart. Immutable. */
final class TilePainter {
    static final int SIDE = 32;
    static final double TILE_METRES = SIDE * Floor.SAMPLE_METRES;
    private static final double WHITE = 255;

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
        double[] flat = {WHITE, WHITE, WHITE};
        double[] rgb = null;
        boolean[] covered = new boolean[SIDE * SIDE];
        for (Layer layer : layers) {
            int count = cover(layer, x, y, covered);
            boolean whole = count == covered.length && layer.paint().texture().isEmpty();
            if (count > 0 && whole && rgb == null) {
                // Most tiles lie wholly inside or outside of all shapes: one colour does for them.
                mix(flat, 0, flat(layer.paint()), layer.paint().opacity());
            } else if (count > 0) {
                rgb = rgb == null ? spread(flat) : rgb;
                blend(layer.paint(), x, y, covered, rgb);
            }
        }
        return onTable(x, y, covered, rgb == null ? new int[] {packed(flat, 0)} : packed(rgb));
    }

    /** How many samples of the tile a layer covers. */
    private static int cover(Layer layer, double x, double y, boolean[] covered) {
        double[] box = layer.bounds();
        if (box[0] > x + TILE_METRES || box[2] < x || box[1] > y + TILE_METRES || box[3] < y) {
            return 0;
        }
        layer.raster().cover(x, y, covered);
        int count = 0;
        for (boolean each : covered) {
            count += each ? 1 : 0;
        }
        return count;
    }

    private int[] onTable(double x, double y, boolean[] covered, int[] tile) {
        if (table != null) {
            table.cover(x, y, covered);
            int[] all = new int[covered.length];
            for (int i = 0; i < all.length; i++) {
                all[i] = covered[i] ? tile[tile.length == 1 ? 0 : i] : Floor.NO_FLOOR;
            }
            return compact(all);
        }
        return compact(tile);
    }

    private static void blend(Paint paint, double x, double y, boolean[] covered, double[] rgb) {
        Texture texture = paint.texture().orElse(null);
        int flat = flat(paint);
        for (int i = 0; i < covered.length; i++) {
            if (covered[i]) {
                int argb = texture == null ? flat : texture.argbAt(centre(x, i % SIDE), centre(y, i / SIDE));
                double opacity = texture == null ? paint.opacity() : paint.opacity() * (argb >>> 24) / 255;
                mix(rgb, i, argb, opacity);
            }
        }
    }

    private static int flat(Paint paint) {
        return paint.colour().red() << 16 | paint.colour().green() << 8 | paint.colour().blue();
    }

    private static void mix(double[] rgb, int sample, int colour, double opacity) {
        rgb[3 * sample] += ((colour >> 16 & 255) - rgb[3 * sample]) * opacity;
        rgb[3 * sample + 1] += ((colour >> 8 & 255) - rgb[3 * sample + 1]) * opacity;
        rgb[3 * sample + 2] += ((colour & 255) - rgb[3 * sample + 2]) * opacity;
    }

    private static double[] spread(double[] flat) {
        double[] rgb = new double[3 * SIDE * SIDE];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = flat[i % 3];
        }
        return rgb;
    }

    /** Coordinate of the middle of the n-th sample. */
    static double centre(double start, int n) {
        return start + (n + 0.5) * Floor.SAMPLE_METRES;
    }

    private static int[] packed(double[] rgb) {
        int[] tile = new int[SIDE * SIDE];
        for (int i = 0; i < tile.length; i++) {
            tile[i] = packed(rgb, i);
        }
        return tile;
    }

    private static int packed(double[] rgb, int sample) {
        return component(rgb[3 * sample]) << 16 | component(rgb[3 * sample + 1]) << 8 | component(rgb[3 * sample + 2]);
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
