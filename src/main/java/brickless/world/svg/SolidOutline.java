package brickless.world.svg;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.operation.valid.IsSimpleOp;

/**
 * The body of a solid shape: simple clockwise polygons without holes. Filled shapes give the outline of the fill; a
 * line drawn without fill gives the outline of the line. Only comparisons and basic arithmetic are used, so the result
 * is the same on every machine.
 */
final class SolidOutline {
    private static final GeometryFactory GEOMETRY = new GeometryFactory();
    /** Points nearer than this are one point, metres. */
    private static final double NEAREST_METRES = 1e-6;
    /** Smallest area of a body, square metres (one square millimetre). */
    private static final double LEAST_AREA = 1e-6;

    private SolidOutline() {}

    static List<List<Point2>> of(DrawnShape shape) throws MalformedValueException {
        shape.refuseClipping();
        if (shape.isFilled()) {
            return filled(shape);
        }
        List<List<Point2>> pieces = shape.strokePieces();
        if (shape.scope().style().fill().isEmpty() && shape.scope().style().stroke().isEmpty()) {
            throw new MalformedValueException("a solid shape with neither fill nor stroke cannot be seen; give it one");
        }
        if (pieces.isEmpty()) {
            throw new MalformedValueException(
                    "a solid shape needs an area; draw a filled shape or a line with a stroke");
        }
        return pieces;
    }

    private static List<List<Point2>> filled(DrawnShape shape) throws MalformedValueException {
        List<List<Point2>> rings = new ArrayList<>();
        for (List<Point2> raw : shape.fillRings()) {
            List<Point2> ring = Rings.withoutCollinear(Rings.withoutRepeats(raw, true, NEAREST_METRES), NEAREST_METRES);
            if (ring.size() >= 3) {
                rings.add(ring);
            }
        }
        refuseCrossings(rings);
        List<List<Point2>> bodies = RingNesting.polygons(rings, shape.scope().style().evenOdd());
        bodies.removeIf(ring -> Rings.doubleArea(ring) / 2 < LEAST_AREA);
        if (bodies.isEmpty()) {
            throw new MalformedValueException("a solid shape needs an area of at least 1 square millimetre");
        }
        return bodies;
    }

    private static void refuseCrossings(List<List<Point2>> rings) throws MalformedValueException {
        List<LineString> lines = new ArrayList<>();
        for (List<Point2> ring : rings) {
            LinearRing line = GEOMETRY.createLinearRing(coordinates(ring));
            if (!new IsSimpleOp(line).isSimple()) {
                throw new MalformedValueException(
                        "the outline of a solid shape crosses or touches itself; draw it without crossings"
                        + " (Inkscape: Path > Union)");
            }
            for (LineString other : lines) {
                if (other.getEnvelopeInternal().intersects(line.getEnvelopeInternal()) && other.intersects(line)) {
                    throw new MalformedValueException(
                            "two outlines of a solid shape cross or touch each other; draw them as separate shapes"
                            + " (Inkscape: Path > Break Apart)");
                }
            }
            lines.add(line);
        }
    }

    private static Coordinate[] coordinates(List<Point2> ring) {
        Coordinate[] coordinates = new Coordinate[ring.size() + 1];
        for (int i = 0; i < coordinates.length; i++) {
            Point2 p = ring.get(i % ring.size());
            coordinates[i] = new Coordinate(p.x(), p.y());
        }
        return coordinates;
    }
}
