package brickless.world;

import java.util.List;

/** A part of the plane. Curves are flattened already; membership is pure arithmetic, the same on every machine. */
public sealed interface Region permits Region.Filled, Region.Stroked {
    /** Whether the point (metres) lies inside. */
    boolean contains(double x, double y);

    /** Smallest upright box: minX, minY, maxX, maxY in metres. */
    double[] bounds();

    /** The inside of closed rings; {@code evenOdd} selects the fill rule, otherwise non-zero. */
    record Filled(List<List<Point2>> rings, boolean evenOdd) implements Region {
        public Filled {
            rings = rings.stream().map(List::copyOf).toList();
        }

        @Override
        public boolean contains(double x, double y) {
            int winding = 0;
            int crossings = 0;
            for (List<Point2> ring : rings) {
                for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                    Point2 a = ring.get(j);
                    Point2 b = ring.get(i);
                    if (a.y() <= y == b.y() <= y) {
                        continue;
                    }
                    double side = (b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y());
                    boolean downwards = b.y() > a.y();
                    if (downwards == side > 0) {
                        crossings++;
                        winding += downwards ? 1 : -1;
                    }
                }
            }
            return evenOdd ? (crossings & 1) == 1 : winding != 0;
        }

        @Override
        public double[] bounds() {
            return Bounds.of(rings, 0);
        }
    }

    /** Everything within half a stroke width of polylines; {@code closed} joins last to first. Ends are round. */
    record Stroked(List<List<Point2>> lines, double widthMetres, boolean closed) implements Region {
        public Stroked {
            lines = lines.stream().map(List::copyOf).toList();
        }

        @Override
        public boolean contains(double x, double y) {
            double limit = widthMetres * widthMetres / 4;
            for (List<Point2> line : lines) {
                int n = line.size();
                for (int i = closed ? 0 : 1; i < n; i++) {
                    if (Bounds.distanceSquared(line.get(i == 0 ? n - 1 : i - 1), line.get(i), x, y) <= limit) {
                        return true;
                    }
                }
            }
            return false;
        }

        @Override
        public double[] bounds() {
            return Bounds.of(lines, widthMetres / 2);
        }
    }
}
