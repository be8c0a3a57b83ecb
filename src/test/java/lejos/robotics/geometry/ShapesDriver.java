package lejos.robotics.geometry;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;

/** Asks lines and rectangles everything, with coordinates from a small grid so that corners and edges are often met. */
final class ShapesDriver {
    private ShapesDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        Sightings seen = new Sightings();
        double[] c = random.ints(8, -3, 4).mapToDouble(i -> i).toArray();
        if (seed % 2 == 1) {
            for (int i = 0; i < c.length; i++) {
                c[i] += random.nextInt(4) / 4.0;
            }
        }
        lines(seen, c);
        rectangles(seen, "double ", new Rectangle2D.Double(c[0], c[1], c[2], c[3]), c);
        rectangles(seen, "float ", new Rectangle((float) c[0], (float) c[1], (float) c[2], (float) c[3]), c);
        rectangles(seen, "int ", new RectangleInt32((int) c[0], (int) c[1], (int) c[2], (int) c[3]), c);
        wholeRectangles(seen, c);
        return seen;
    }

    private static void lines(Sightings seen, double[] c) {
        seen.note("ccw", Line2D.relativeCCW(c[0], c[1], c[2], c[3], c[4], c[5]));
        seen.note("cross", Line2D.linesIntersect(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]));
        seen.note("near", Line2D.ptSegDist(c[0], c[1], c[2], c[3], c[4], c[5]));
        seen.note("nearSq", Line2D.ptSegDistSq(c[0], c[1], c[2], c[3], c[4], c[5]));
        Line2D line = new Line2D.Double(c[0], c[1], c[2], c[3]);
        seen.note("inside", line.contains(c[0], c[1]) || line.contains(0, 0, 1, 1) || line.contains(line.getP1()));
        seen.note("meets", line.intersects(c[4], c[5], c[6], c[7]));
        bounds(seen, "line ", line);
        line.setLine(new Point2D.Double(c[4], c[5]), new Point2D.Float((float) c[6], (float) c[7]));
        seen.note("x1", line.getX1()).note("y1", line.getY1()).note("x2", line.getX2()).note("y2", line.getY2());
        seen.note("ccw here", line.relativeCCW(c[0], c[1]))
                .note("near here", line.ptSegDist(new Point2D.Double(c[0], c[1])));
        Line2D narrow = new Line2D.Float((float) c[0], (float) c[1], (float) c[2], (float) c[3]);
        bounds(seen, "narrow ", narrow);
        seen.note("cross narrow", narrow.intersectsLine(line));
    }

    private static void rectangles(Sightings seen, String name, Rectangle2D r, double[] c) {
        seen.note(name + "outcode", r.outcode(c[4], c[5])).note(name + "empty", r.isEmpty());
        seen.note(name + "contains point", r.contains(c[4], c[5]))
                .note(name + "contains p", r.contains(new Point2D.Double(c[4], c[5])));
        seen.note(name + "contains rect", r.contains(c[4], c[5], c[6], c[7]));
        seen.note(name + "meets", r.intersects(c[4], c[5], c[6], c[7]));
        seen.note(name + "itself", r.contains(r)).note(name + "meets itself", r.intersects(r));
        seen.note(name + "line", r.intersectsLine(c[4], c[5], c[6], c[7]));
        seen.note(name + "centre x", r.getCenterX()).note(name + "centre y", r.getCenterY());
        seen.note(name + "max x", r.getMaxX()).note(name + "min y", r.getMinY());
        seen.note(name + "equal", r.equals(new Rectangle2D.Double(c[0], c[1], c[2], c[3])));
        bounds(seen, name, r);
        Rectangle2D copy = (Rectangle2D) r.clone();
        copy.setFrame(c[4], c[5], c[6], c[7]);
        seen.note(name + "moved w", copy.getWidth()).note(name + "moved x", copy.getX());
        seen.note(name + "moved y", copy.getY()).note(name + "moved h", copy.getHeight());
        copy.setRect(r.getFrame());
        seen.note(name + "frame", copy.equals(r));
    }

    private static void wholeRectangles(Sightings seen, double[] c) {
        RectangleInt32 r = new RectangleInt32((int) c[0], (int) c[1], (int) c[2], (int) c[3]);
        RectangleInt32 s = new RectangleInt32((int) c[4], (int) c[5], (int) c[6], (int) c[7]);
        seen.note("whole contains whole", r.contains(s)).note("whole contains itself", r.contains(r));
        seen.note("whole meets whole", r.intersects(s));
        seen.note("whole contains", r.contains((int) c[4], (int) c[5]));
        seen.note("whole contains Point", r.contains(new Point((float) c[4], (float) c[5])));
        RectangleInt32 at = new RectangleInt32(new Point((float) c[4], (float) c[5]));
        seen.note("at x", at.x).note("at y", at.y).note("at w", at.width);
        r.setLocation(new Point((float) c[4], (float) c[5]));
        seen.note("moved x", r.x).note("moved location", r.getLocation().x);
        r.setRect(c[4], c[5], c[6], c[7]);
        seen.note("set x", r.x).note("set y", r.y).note("set w", r.width).note("set h", r.height);
    }

    private static void bounds(Sightings seen, String name, Shape shape) {
        RectangleInt32 r = shape.getBounds();
        seen.note(name + "b x", r.x).note(name + "b y", r.y).note(name + "b w", r.width).note(name + "b h", r.height);
        Rectangle2D d = shape.getBounds2D();
        seen.note(name + "bx", d.getX()).note(name + "by", d.getY());
        seen.note(name + "bw", d.getWidth()).note(name + "bh", d.getHeight());
    }
}
