package brickless.physics;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Cuts a simple polygon into convex pieces of at most eight corners: slices of a round one, else ear clipping, then
 * merging over shared diagonals.
 * The result depends on the order of the corners only, never on hashing.
 */
final class ConvexParts {
    /** Most corners of a JBox2D polygon. */
    static final int MAX_CORNERS = 8;
    /** Corners closer than this are one, metres; smaller details would only upset the contact solver. */
    private static final double MERGE_DISTANCE = 2e-4;
    /** Pieces smaller than this are dropped, square metres. */
    private static final double SMALLEST_AREA = 1e-8;
    /** How far a corner may be dented and still count as convex, square metres (twice the area of the dent). */
    private static final double CONVEX_TOLERANCE = 1e-12;

    private ConvexParts() {}

    /** Convex pieces with positive orientation (x towards y); empty if the outline encloses no area. */
    static List<List<Point2>> of(List<Point2> outline) {
        List<Point2> ring = oriented(cleaned(outline));
        if (ring.size() < 3) {
            return List.of();
        }
        List<List<Point2>> pieces = slices(ring);
        if (!pieces.stream().allMatch(ConvexParts::convex)) {
            pieces = ears(ring);
            mergeAll(pieces);
        }
        pieces.removeIf(piece -> signedArea(piece) < SMALLEST_AREA);
        return pieces;
    }

    /** Area with sign, square metres; positive if the corners run from x towards y. */
    static double signedArea(List<Point2> ring) {
        double twice = 0;
        for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            twice += ring.get(j).x() * ring.get(i).y() - ring.get(i).x() * ring.get(j).y();
        }
        return twice / 2;
    }

    private static List<Point2> cleaned(List<Point2> outline) {
        List<Point2> ring = new ArrayList<>();
        for (Point2 p : outline) {
            if (ring.isEmpty() || !near(ring.get(ring.size() - 1), p)) {
                ring.add(p);
            }
        }
        while (ring.size() > 1 && near(ring.get(0), ring.get(ring.size() - 1))) {
            ring.remove(ring.size() - 1);
        }
        return ring;
    }

    private static boolean near(Point2 a, Point2 b) {
        double dx = a.x() - b.x();
        double dy = a.y() - b.y();
        return dx * dx + dy * dy < MERGE_DISTANCE * MERGE_DISTANCE;
    }

    private static List<Point2> oriented(List<Point2> ring) {
        if (signedArea(ring) >= 0) {
            return ring;
        }
        List<Point2> reversed = new ArrayList<>(ring);
        Collections.reverse(reversed);
        return reversed;
    }

    /**
     * A round outline is cut like a pie. Ears of it would be thin slivers: what gets a few millimetres into one would
     * be pushed on towards the middle instead of out.
     */
    private static List<List<Point2>> slices(List<Point2> ring) {
        if (ring.size() <= MAX_CORNERS || !convex(ring)) {
            return new ArrayList<>(List.of(ring));
        }
        Point2 middle = Shapes.centroid(List.of(ring));
        int count = Math.max(3, (ring.size() + MAX_CORNERS - 3) / (MAX_CORNERS - 2));
        List<List<Point2>> slices = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            List<Point2> slice = new ArrayList<>(List.of(middle));
            for (int corner = i * ring.size() / count; corner <= (i + 1) * ring.size() / count; corner++) {
                slice.add(ring.get(corner % ring.size()));
            }
            slices.add(slice);
        }
        return slices;
    }

    private static List<List<Point2>> ears(List<Point2> ring) {
        List<Point2> rest = new ArrayList<>(ring);
        List<List<Point2>> triangles = new ArrayList<>();
        while (rest.size() > 3) {
            int ear = earOf(rest);
            int n = rest.size();
            triangles.add(List.of(rest.get((ear + n - 1) % n), rest.get(ear), rest.get((ear + 1) % n)));
            rest.remove(ear);
        }
        triangles.add(List.copyOf(rest));
        return triangles;
    }

    /**
     * Index of a corner that can be cut off; for outlines that touch themselves the flattest corner, so that the loop
     * always ends.
     */
    private static int earOf(List<Point2> ring) {
        int flattest = 0;
        double smallest = Double.POSITIVE_INFINITY;
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            Point2 a = ring.get((i + n - 1) % n);
            Point2 b = ring.get(i);
            Point2 c = ring.get((i + 1) % n);
            double turn = turn(a, b, c);
            if (turn > 0 && noneInside(ring, a, b, c)) {
                return i;
            }
            if (Math.abs(turn) < smallest) {
                smallest = Math.abs(turn);
                flattest = i;
            }
        }
        return flattest;
    }

    private static boolean noneInside(List<Point2> ring, Point2 a, Point2 b, Point2 c) {
        for (Point2 p : ring) {
            if (p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0
                    && !p.equals(a) && !p.equals(b) && !p.equals(c)) {
                return false;
            }
        }
        return true;
    }

    private static double turn(Point2 a, Point2 b, Point2 c) {
        return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
    }

    private static void mergeAll(List<List<Point2>> pieces) {
        for (int i = 0; i < pieces.size(); i++) {
            for (int j = i + 1; j < pieces.size(); j++) {
                List<Point2> merged = merged(pieces.get(i), pieces.get(j));
                if (merged != null) {
                    pieces.set(i, merged);
                    pieces.remove(j);
                    j = i;
                }
            }
        }
    }

    /** The union of two pieces that share one edge, or null if they do not or it would not be a legal piece. */
    private static List<Point2> merged(List<Point2> p, List<Point2> q) {
        int n = p.size();
        int m = q.size();
        if (n + m - 2 > MAX_CORNERS) {
            return null;
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < m; j++) {
                if (p.get(i).equals(q.get((j + 1) % m)) && p.get((i + 1) % n).equals(q.get(j))) {
                    List<Point2> union = spliced(p, i, q, j);
                    return convex(union) ? union : null;
                }
            }
        }
        return null;
    }

    private static List<Point2> spliced(List<Point2> p, int i, List<Point2> q, int j) {
        List<Point2> union = new ArrayList<>();
        for (int k = 1; k <= p.size(); k++) {
            union.add(p.get((i + k) % p.size()));
        }
        for (int k = 2; k < q.size(); k++) {
            union.add(q.get((j + k) % q.size()));
        }
        return union;
    }

    private static boolean convex(List<Point2> ring) {
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            if (turn(ring.get(i), ring.get((i + 1) % n), ring.get((i + 2) % n)) <= CONVEX_TOLERANCE) {
                return false;
            }
        }
        return true;
    }
}
