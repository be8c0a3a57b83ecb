package brickless.world;

import java.util.Arrays;
import java.util.List;

/** Tells for all samples of a tile at once whether a region covers them. Immutable. */
final class RegionRaster {
    private final Region region;
    private final boolean evenOdd;
    /** Edges of a filled region, four numbers each: x1, y1, x2, y2; null for others. */
    private final double[] edges;

    private RegionRaster(Region region, boolean evenOdd, double[] edges) {
        this.region = region;
        this.evenOdd = evenOdd;
        this.edges = edges;
    }

    static RegionRaster of(Region region) {
        return region instanceof Region.Filled filled
                ? new RegionRaster(region, filled.evenOdd(), edges(filled.rings()))
                : new RegionRaster(region, false, null);
    }

    private static double[] edges(List<List<Point2>> rings) {
        double[] edges = new double[4 * rings.stream().mapToInt(List::size).sum()];
        int k = 0;
        for (List<Point2> ring : rings) {
            for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                edges[k++] = ring.get(j).x();
                edges[k++] = ring.get(j).y();
                edges[k++] = ring.get(i).x();
                edges[k++] = ring.get(i).y();
            }
        }
        return edges;
    }

    /** Fills {@code covered} for the tile whose upper left corner is given. */
    void cover(double left, double top, boolean[] covered) {
        if (edges == null) {
            for (int i = 0; i < covered.length; i++) {
                covered[i] = region.contains(TilePainter.centre(left, i % TilePainter.SIDE),
                        TilePainter.centre(top, i / TilePainter.SIDE));
            }
            return;
        }
        int[] steps = new int[(TilePainter.SIDE + 1) * TilePainter.SIDE];
        double bottom = top + TilePainter.TILE_METRES;
        for (int k = 0; k < edges.length; k += 4) {
            double low = Math.min(edges[k + 1], edges[k + 3]);
            double high = Math.max(edges[k + 1], edges[k + 3]);
            if (low <= bottom && high >= top && low != high) {
                cross(k, left, top, low, high, steps);
            }
        }
        sum(steps, covered);
    }

    /** Notes in which column each row crosses an edge, and in which direction. */
    private void cross(int k, double left, double top, double low, double high, int[] steps) {
        double x1 = edges[k];
        double y1 = edges[k + 1];
        double slope = (edges[k + 2] - x1) / (edges[k + 3] - y1);
        int direction = edges[k + 3] > y1 ? 1 : -1;
        int first = (int) Math.max(0, Math.floor((low - top) / Floor.SAMPLE_METRES - 0.5));
        for (int row = first; row < TilePainter.SIDE; row++) {
            double y = TilePainter.centre(top, row);
            if (y >= high) {
                return;
            }
            if (y >= low) {
                double x = x1 + (y - y1) * slope;
                double column = Math.ceil((x - left) / Floor.SAMPLE_METRES - 0.5);
                steps[row * (TilePainter.SIDE + 1)
                        + (int) Math.max(0, Math.min(TilePainter.SIDE, column))] += direction;
            }
        }
    }

    private void sum(int[] steps, boolean[] covered) {
        Arrays.fill(covered, false);
        for (int row = 0; row < TilePainter.SIDE; row++) {
            int winding = 0;
            for (int column = 0; column < TilePainter.SIDE; column++) {
                winding += steps[row * (TilePainter.SIDE + 1) + column];
                covered[row * TilePainter.SIDE + column] = evenOdd ? (winding & 1) == 1 : winding != 0;
            }
        }
    }
}
