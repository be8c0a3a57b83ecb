package lejos.robotics.geometry;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;

/** Asks points and lines everything, with coordinates large enough that no line ends on another by chance. */
final class PointsDriver {
    private PointsDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        float[] c = new float[8];
        for (int i = 0; i < c.length; i++) {
            c[i] = seed % 5 == 0 ? random.nextInt(7) - 3 : random.nextFloat() * 200 - 100;
        }
        Sightings seen = new Sightings();
        points(seen, c);
        vectors(seen, c);
        if (seed % 5 != 0) {
            lines(seen, c);
        }
        return seen;
    }

    private static void points(Sightings seen, float[] c) {
        Point p = new Point(c[0], c[1]);
        Point q = new Point(c[2], c[3]);
        seen.note("angleTo", p.angleTo(q)).note("angle", p.angle());
        note(seen, "pointAt", p.pointAt(c[4], c[5] * 4));
        note(seen, "unit", new Point(c[6] / 20));
        note(seen, "moved", moved(p, c));
        note(seen, "copied", p.copyTo(q.clone()));
        seen.note("equal", p.equals(q) || !p.equals(new Point2D.Double(c[0], c[1])));
        seen.note("distance", p.distance(q)).note("distanceSq", p.distanceSq(c[4], c[5]));
        Point r = p.clone();
        r.moveTo(q);
        note(seen, "moveTo", r);
        r.setLocation(c[4], c[5]);
        note(seen, "location", r);
    }

    private static Point moved(Point p, float[] c) {
        Point moved = p.clone();
        moved.translate(c[4], c[5]);
        return moved;
    }

    private static void vectors(Sightings seen, float[] c) {
        Point p = new Point(c[0], c[1]);
        Point q = new Point(c[2], c[3]);
        note(seen, "add", p.add(q));
        note(seen, "addWith", p.clone().addWith(q));
        note(seen, "subtract", p.subtract(q));
        note(seen, "subtractWith", p.clone().subtractWith(q));
        note(seen, "multiply", p.multiply(c[4]));
        note(seen, "multiplyBy", p.clone().multiplyBy(c[4]));
        note(seen, "normalized", p.getNormalized());
        note(seen, "normalize", p.clone().normalize());
        note(seen, "reverse", p.reverse());
        note(seen, "left", p.leftOrth());
        note(seen, "right", p.rightOrth());
        note(seen, "makeLeft", p.clone().makeLeftOrth());
        note(seen, "makeRight", p.clone().makeRightOrth());
        seen.note("length", p.length()).note("dot", p.dotProduct(q));
        if (p.length() > 0) {
            note(seen, "shorter", p.subtract(c[4]));
        }
        note(seen, "unchanged", p);
    }

    private static void lines(Sightings seen, float[] c) {
        Line line = new Line(c[0], c[1], c[2], c[3]);
        Line other = new Line(c[4], c[5], c[6], c[7]);
        Point crossing = line.intersectsAt(other);
        seen.note("crosses", crossing != null);
        if (crossing != null) {
            note(seen, "crossing", crossing);
        }
        seen.note("gap", line.segDist(other)).note("gap back", other.segDist(line)).note("line length", line.length());
        note(seen, "project", new Point(c[4], c[5]).projectOn(line));
        line.lengthen(c[6] / 10);
        note(seen, "from", line.getP1());
        note(seen, "to", line.getP2());
    }

    private static void note(Sightings seen, String label, Point p) {
        seen.note(label + ".x", p.x).note(label + ".y", p.y);
    }
}
