package brickless.world.svg;

import brickless.units.Lengths;
import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;

/**
 * A shape with everything that groups, {@code use} and style sheets contribute.
 *
 * @param element the shape
 * @param scope transform, style and meaning at the shape
 * @param paths its outline in its own user units
 * @param tolerance flatness in those units
 * @param budget what it may still cost
 */
record DrawnShape(SvgElement element, Scope scope, List<SubPath> paths, double tolerance, PointBudget budget) {
    /** Rings thinner than this have no inside. */
    private static final double FLAT_METRES = 1e-9;

    /** Closed rings of the inside, metres on the page; rings without area are left out. */
    List<List<Point2>> fillRings() {
        List<List<Point2>> rings = new ArrayList<>();
        for (SubPath path : paths) {
            List<Point2> ring = toMetres(path.points());
            if (!Rings.isFlat(ring, FLAT_METRES)) {
                rings.add(ring);
            }
        }
        return rings;
    }

    /** The drawn line as convex clockwise pieces, metres on the page; empty without a stroke. */
    List<List<Point2>> strokePieces() throws MalformedValueException {
        Style.StrokeStyle line = scope.style().line();
        if (scope.style().stroke().isEmpty() || line.width() <= 0 || scope.toPage().isSingular()) {
            return List.of();
        }
        List<SubPath> lines = line.fixedWidth() ? onPage() : paths;
        double flatness = line.fixedWidth() ? Limits.FLATNESS_MILLIMETRES : tolerance;
        List<List<Point2>> pieces = new ArrayList<>();
        for (List<Point2> piece : StrokeOutline.of(lines, line, line.width(), flatness, budget)) {
            List<Point2> ring = Rings.clockwise(line.fixedWidth() ? metres(piece) : toMetres(piece));
            if (Rings.doubleArea(ring) > 1e-10) {
                pieces.add(ring);
            }
        }
        return pieces;
    }

    /** Whether it is drawn with a fill that covers an area. */
    boolean isFilled() {
        return scope.style().fill().isPresent() && !fillRings().isEmpty();
    }

    /** Refuses what would make the drawing look different from what is simulated. */
    void refuseClipping() throws MalformedValueException {
        if (scope.style().clipped()) {
            throw new MalformedValueException(
                    "clip-path and mask are not supported; cut the shape itself (Inkscape: Path > Intersection)");
        }
    }

    private List<SubPath> onPage() {
        List<SubPath> moved = new ArrayList<>();
        for (SubPath path : paths) {
            moved.add(new SubPath(path.points().stream().map(scope.toPage()::apply).toList(), path.closed()));
        }
        return moved;
    }

    private List<Point2> toMetres(List<Point2> points) {
        return metres(points.stream().map(scope.toPage()::apply).toList());
    }

    private static List<Point2> metres(List<Point2> points) {
        return points.stream().map(p -> new Point2(Lengths.metresFromMillimetres(p.x()),
                Lengths.metresFromMillimetres(p.y()))).toList();
    }
}
