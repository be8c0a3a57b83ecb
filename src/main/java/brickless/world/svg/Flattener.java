package brickless.world.svg;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;

/** Turns pen movements into polylines that stay within a tolerance of the curves. Units: those of the element. */
final class Flattener {
    private static final int MAX_PIECES_PER_CURVE = 2_000;

    private final double tolerance;
    private final PointBudget budget;
    private final List<SubPath> done = new ArrayList<>();
    private List<Point2> points = new ArrayList<>();
    private Point2 start = new Point2(0, 0);
    private Point2 pen = start;

    Flattener(double tolerance, PointBudget budget) {
        this.tolerance = tolerance;
        this.budget = budget;
    }

    Point2 pen() {
        return pen;
    }

    void moveTo(Point2 to) {
        finish(false);
        start = to;
        pen = to;
    }

    void lineTo(Point2 to) throws MalformedValueException {
        if (points.isEmpty()) {
            add(pen);
            start = pen;
        }
        add(to);
    }

    void close() throws MalformedValueException {
        if (points.isEmpty()) {
            add(pen);
        }
        finish(true);
        pen = start;
    }

    void quadTo(Point2 control, Point2 to) throws MalformedValueException {
        Point2 from = pen;
        cubicTo(between(from, control, 2.0 / 3), between(to, control, 2.0 / 3), to);
    }

    void cubicTo(Point2 c1, Point2 c2, Point2 to) throws MalformedValueException {
        Point2 p = pen;
        double bend = Math.max(bend(p, c1, c2), bend(c1, c2, to));
        int pieces = pieces(Math.sqrt(0.75 * bend / tolerance));
        for (int i = 1; i < pieces; i++) {
            double t = (double) i / pieces;
            double s = 1 - t;
            double w0 = s * s * s;
            double w1 = 3 * s * s * t;
            double w2 = 3 * s * t * t;
            double w3 = t * t * t;
            lineTo(new Point2(w0 * p.x() + w1 * c1.x() + w2 * c2.x() + w3 * to.x(), w0 * p.y() + w1 * c1.y()
                    + w2 * c2.y() + w3 * to.y()));
        }
        lineTo(to);
    }

    /**
     * The arc of an ellipse; angles in radians in the ellipse's own parameter, {@code axes} maps the unit circle to it.
     */
    void arc(Affine axes, double fromRadians, double sweepRadians, Point2 end) throws MalformedValueException {
        double radius = axes.greatestScale();
        double step = radius <= tolerance ? Math.PI / 4 : 2 * StrictMath.acos(1 - tolerance / radius);
        int pieces = pieces(Math.abs(sweepRadians) / Math.min(step, Math.PI / 4));
        for (int i = 1; i < pieces; i++) {
            double angle = fromRadians + sweepRadians * i / pieces;
            lineTo(axes.apply(new Point2(StrictMath.cos(angle), StrictMath.sin(angle))));
        }
        lineTo(end);
    }

    /** Ends the drawing. */
    List<SubPath> result() {
        finish(false);
        return done;
    }

    private static int pieces(double exact) throws MalformedValueException {
        if (!(exact <= Limits.COORDINATE)) {
            throw new MalformedValueException("a curve is too large");
        }
        return (int) Math.max(1, Math.min(MAX_PIECES_PER_CURVE, Math.ceil(exact)));
    }

    private void add(Point2 point) throws MalformedValueException {
        budget.spend(1);
        points.add(point);
        pen = point;
    }

    private void finish(boolean closed) {
        if (!points.isEmpty()) {
            done.add(new SubPath(points, closed));
            points = new ArrayList<>();
        }
    }

    private static double bend(Point2 a, Point2 b, Point2 c) {
        double x = a.x() - 2 * b.x() + c.x();
        double y = a.y() - 2 * b.y() + c.y();
        return Math.sqrt(x * x + y * y);
    }

    private static Point2 between(Point2 a, Point2 b, double share) {
        return new Point2(a.x() + (b.x() - a.x()) * share, a.y() + (b.y() - a.y()) * share);
    }
}
