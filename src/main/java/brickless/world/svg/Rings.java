package brickless.world.svg;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Arithmetic on closed rings of points. */
final class Rings {
    private Rings() {}

    /** Twice the area, positive when the ring runs clockwise on the page (y down). */
    static double doubleArea(List<Point2> ring) {
        double sum = 0;
        for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            Point2 a = ring.get(j);
            Point2 b = ring.get(i);
            sum += a.x() * b.y() - b.x() * a.y();
        }
        return sum;
    }

    /**
     * Whether all points lie on one line, so that the ring has no inside. (A bow tie has one, although its signed area
     * is 0.)
     */
    static boolean isFlat(List<Point2> ring, double nearest) {
        Point2 first = ring.get(0);
        Point2 far = first;
        for (Point2 p : ring) {
            far = distance(first, p) > distance(first, far) ? p : far;
        }
        double length = distance(first, far);
        for (Point2 p : ring) {
            double cross = (far.x() - first.x()) * (p.y() - first.y()) - (far.y() - first.y()) * (p.x() - first.x());
            if (Math.abs(cross) > nearest * length) {
                return false;
            }
        }
        return true;
    }

    static List<Point2> clockwise(List<Point2> ring) {
        if (doubleArea(ring) >= 0) {
            return ring;
        }
        List<Point2> turned = new ArrayList<>(ring);
        Collections.reverse(turned);
        return turned;
    }

    /** Without points nearer than {@code nearest} to their predecessor, the closing one included. */
    static List<Point2> withoutRepeats(List<Point2> points, boolean closed, double nearest) {
        List<Point2> kept = new ArrayList<>();
        for (Point2 p : points) {
            if (kept.isEmpty() || distance(kept.get(kept.size() - 1), p) > nearest) {
                kept.add(p);
            }
        }
        while (closed && kept.size() > 1 && distance(kept.get(0), kept.get(kept.size() - 1)) <= nearest) {
            kept.remove(kept.size() - 1);
        }
        return kept;
    }

    /** Without points that lie on the straight line between their neighbours. */
    static List<Point2> withoutCollinear(List<Point2> ring, double nearest) {
        List<Point2> kept = new ArrayList<>();
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            Point2 before = kept.isEmpty() ? ring.get(n - 1) : kept.get(kept.size() - 1);
            Point2 here = ring.get(i);
            Point2 after = ring.get((i + 1) % n);
            double cross = (here.x() - before.x()) * (after.y() - here.y())
                    - (here.y() - before.y()) * (after.x() - here.x());
            double dot = (here.x() - before.x()) * (after.x() - here.x())
                    + (here.y() - before.y()) * (after.y() - here.y());
            if (Math.abs(cross) > nearest * distance(before, after) || dot < 0) {
                kept.add(here);
            }
        }
        return kept;
    }

    static double distance(Point2 a, Point2 b) {
        double dx = a.x() - b.x();
        double dy = a.y() - b.y();
        return Math.sqrt(dx * dx + dy * dy);
    }
}
