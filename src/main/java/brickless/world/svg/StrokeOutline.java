package brickless.world.svg;

import brickless.world.Point2;
import brickless.world.svg.Style.StrokeStyle;
import java.util.ArrayList;
import java.util.List;

/**
 * The area of a drawn line as convex clockwise pieces, which may overlap: one per straight piece, cut along the
 * bisector where it meets the next, and one for each cap or corner that cannot be cut so. Pure arithmetic; units are
 * the element's.
 */
final class StrokeOutline {
    /** Corners gentler than this are always mitred: they come from flattened curves. */
    private static final double GENTLE_TURN_COSINE = 0.94;

    private final StrokeStyle style;
    private final double half;
    private final double tolerance;
    private final PointBudget budget;
    private final List<List<Point2>> pieces = new ArrayList<>();

    private StrokeOutline(StrokeStyle style, double width, double tolerance, PointBudget budget) {
        this.style = style;
        this.half = width / 2;
        this.tolerance = tolerance;
        this.budget = budget;
    }

    static List<List<Point2>> of(List<SubPath> paths, StrokeStyle style, double width, double tolerance,
            PointBudget budget)
            throws MalformedValueException {
        StrokeOutline outline = new StrokeOutline(style, width, tolerance, budget);
        List<SubPath> lines = style.dashes().isEmpty() ? paths
                : Dashes.split(paths, style.dashes(), style.dashOffset(), budget);
        for (SubPath line : lines) {
            outline.add(line);
        }
        return outline.pieces;
    }

    private void add(SubPath line) throws MalformedValueException {
        double nearest = Math.min(half, tolerance) * 1e-3;
        List<Point2> points = Rings.withoutRepeats(line.points(), line.closed(), nearest);
        if (points.size() == 1) {
            dot(points.get(0), line.points().size() > 1 || line.closed());
        } else if (points.size() > 1) {
            boolean closed = line.closed() && points.size() > 2;
            if (!closed && style.cap().equals("square")) {
                stretch(points);
            }
            segments(points, closed);
            if (!closed && style.cap().equals("round")) {
                disc(points.get(0));
                disc(points.get(points.size() - 1));
            }
        }
    }

    private void segments(List<Point2> points, boolean closed) throws MalformedValueException {
        int n = points.size();
        int count = closed ? n : n - 1;
        double[] cuts = new double[n];
        for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); i++) {
            cuts[i] = corner(points.get((i + n - 1) % n), points.get(i), points.get((i + 1) % n));
        }
        for (int i = 0; i < count; i++) {
            Point2 p = points.get(i);
            Point2 q = points.get((i + 1) % n);
            Point2 d = direction(p, q);
            double a = cuts[i];
            double b = cuts[(i + 1) % n];
            piece(List.of(offset(p, d, a, half), offset(q, d, -b, half), offset(q, d, b, -half),
                    offset(p, d, -a, -half)));
        }
    }

    /**
     * Returns the signed length by which the pieces at a corner are cut along the bisector, or 0 after adding a joint
     * of its own.
     */
    private double corner(Point2 before, Point2 here, Point2 after) throws MalformedValueException {
        Point2 in = direction(before, here);
        Point2 out = direction(here, after);
        double cross = in.x() * out.y() - in.y() * out.x();
        double dot = in.x() * out.x() + in.y() * out.y();
        boolean gentle = dot > GENTLE_TURN_COSINE;
        boolean mitred = style.join().startsWith("miter") && 2 <= style.miterLimit() * style.miterLimit() * (1 + dot)
                && dot > -0.9999;
        double cut = half * cross / (1 + dot);
        double room = Math.min(Rings.distance(before, here), Rings.distance(here, after)) / 2;
        if ((gentle || mitred) && Math.abs(cut) <= room) {
            return cut;
        }
        if (style.join().equals("round") && !gentle) {
            disc(here);
            return 0;
        }
        double side = cross > 0 ? -half : half;
        Point2 a = offset(here, in, 0, side);
        Point2 b = offset(here, out, 0, side);
        piece(gentle || mitred ? List.of(here, a, offset(here, in, Math.abs(cut), side), b) : List.of(here, a, b));
        return 0;
    }

    /** Square ends: the line simply goes on for half its width. */
    private void stretch(List<Point2> points) {
        int last = points.size() - 1;
        Point2 first = points.get(0);
        Point2 back = direction(points.get(1), first);
        Point2 on = direction(points.get(last - 1), points.get(last));
        points.set(last, offset(points.get(last), on, half, 0));
        points.set(0, offset(first, back, half, 0));
    }

    private void dot(Point2 at, boolean drawn) throws MalformedValueException {
        if (drawn && style.cap().equals("round")) {
            disc(at);
        } else if (drawn && style.cap().equals("square")) {
            Point2 d = new Point2(1, 0);
            piece(List.of(offset(at, d, -half, -half), offset(at, d, half, -half), offset(at, d, half, half),
                    offset(at, d, -half, half)));
        }
    }

    private void disc(Point2 centre) throws MalformedValueException {
        int corners = half <= tolerance ? 8
                : (int) Math.max(8, Math.min(64, 4 * Math.ceil(Math.PI / (4 * StrictMath.acos(1 - tolerance / half)))));
        List<Point2> ring = new ArrayList<>();
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            ring.add(new Point2(centre.x() + half * StrictMath.cos(angle), centre.y() + half * StrictMath.sin(angle)));
        }
        piece(ring);
    }

    private void piece(List<Point2> ring) throws MalformedValueException {
        budget.spend(ring.size());
        pieces.add(Rings.clockwise(ring));
    }

    /** {@code along} in direction d from p, {@code aside} to the right hand of d on the page. */
    private static Point2 offset(Point2 p, Point2 d, double along, double aside) {
        return new Point2(p.x() + d.x() * along - d.y() * aside, p.y() + d.y() * along + d.x() * aside);
    }

    private static Point2 direction(Point2 from, Point2 to) {
        double length = Rings.distance(from, to);
        return new Point2((to.x() - from.x()) / length, (to.y() - from.y()) / length);
    }
}
