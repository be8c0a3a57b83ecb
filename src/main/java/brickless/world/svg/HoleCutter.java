package brickless.world.svg;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.TopologyException;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;

/** Cuts polygons through their holes, upright, until none has a hole. */
final class HoleCutter {
    private static final GeometryFactory GEOMETRY = new GeometryFactory();

    private HoleCutter() {}

    static List<List<Point2>> cut(List<List<Point2>> shells, List<List<Point2>> holes) throws MalformedValueException {
        List<List<Point2>> out = new ArrayList<>();
        List<Polygon> outers = shells.stream().map(shell -> GEOMETRY.createPolygon(ring(shell))).toList();
        Map<Polygon, List<LinearRing>> holesOf = new IdentityHashMap<>();
        for (List<Point2> hole : holes) {
            LinearRing ring = ring(hole);
            outers.stream().filter(outer -> outer.getEnvelopeInternal().contains(ring.getEnvelopeInternal())
                    && outer.contains(ring))
                    .min(Comparator.comparingDouble(Polygon::getArea))
                    .ifPresent(outer -> holesOf.computeIfAbsent(outer, key -> new ArrayList<>()).add(ring));
        }
        for (Polygon outer : outers) {
            LinearRing[] inner = holesOf.getOrDefault(outer, List.of()).toArray(LinearRing[]::new);
            open(GEOMETRY.createPolygon(outer.getExteriorRing(), inner), out);
        }
        return out;
    }

    private static void open(Polygon polygon, List<List<Point2>> out) throws MalformedValueException {
        if (polygon.getNumInteriorRing() == 0) {
            out.add(points(polygon.getExteriorRing().getCoordinates()));
            return;
        }
        Envelope all = polygon.getEnvelopeInternal();
        Envelope hole = polygon.getInteriorRingN(0).getEnvelopeInternal();
        double x = (hole.getMinX() + hole.getMaxX()) / 2;
        half(polygon, new Envelope(all.getMinX() - 1, x, all.getMinY() - 1, all.getMaxY() + 1), out);
        half(polygon, new Envelope(x, all.getMaxX() + 1, all.getMinY() - 1, all.getMaxY() + 1), out);
    }

    private static void half(Polygon polygon, Envelope side, List<List<Point2>> out)
            throws MalformedValueException {
        Geometry part = intersection(polygon, side);
        for (int i = 0; i < part.getNumGeometries(); i++) {
            if (part.getGeometryN(i) instanceof Polygon piece && !piece.isEmpty()) {
                open(piece, out);
            }
        }
    }

    private static Geometry intersection(Polygon polygon, Envelope side) throws MalformedValueException {
        try {
            return OverlayNGRobust.overlay(polygon, GEOMETRY.toGeometry(side), OverlayNG.INTERSECTION);
        } catch (TopologyException e) {
            throw new MalformedValueException(
                    "the holes of a solid shape lie too close to its outline or to each other");
        }
    }

    private static LinearRing ring(List<Point2> points) {
        Coordinate[] coordinates = new Coordinate[points.size() + 1];
        for (int i = 0; i < coordinates.length; i++) {
            Point2 p = points.get(i % points.size());
            coordinates[i] = new Coordinate(p.x(), p.y());
        }
        return GEOMETRY.createLinearRing(coordinates);
    }

    private static List<Point2> points(Coordinate[] coordinates) {
        List<Point2> points = new ArrayList<>();
        for (int i = 0; i + 1 < coordinates.length; i++) {
            points.add(new Point2(coordinates[i].x, coordinates[i].y));
        }
        return Rings.clockwise(points);
    }
}
