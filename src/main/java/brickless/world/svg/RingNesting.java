package brickless.world.svg;

import brickless.world.Point2;
import brickless.world.Region;
import java.util.ArrayList;
import java.util.List;

/**
 * Sorts rings that do not cross into bodies and holes by the fill rule, and opens bodies with holes so that each piece
 * is a plain polygon.
 */
final class RingNesting {
    private RingNesting() {}

    static List<List<Point2>> polygons(List<List<Point2>> rings, boolean evenOdd)
            throws MalformedValueException {
        List<List<Point2>> shells = new ArrayList<>();
        List<List<Point2>> holes = new ArrayList<>();
        for (List<Point2> ring : rings) {
            int outside = windingAround(ring, rings, evenOdd);
            int inside = outside + (evenOdd ? 1 : Rings.doubleArea(ring) > 0 ? 1 : -1);
            boolean filledInside = evenOdd ? (inside & 1) == 1 : inside != 0;
            boolean filledOutside = evenOdd ? (outside & 1) == 1 : outside != 0;
            if (filledInside && !filledOutside) {
                shells.add(Rings.clockwise(ring));
            } else if (!filledInside && filledOutside) {
                holes.add(Rings.clockwise(ring));
            }
        }
        return holes.isEmpty() ? shells : HoleCutter.cut(shells, holes);
    }

    private static int windingAround(List<Point2> ring, List<List<Point2>> rings, boolean evenOdd) {
        Point2 point = ring.get(0);
        int winding = 0;
        for (List<Point2> other : rings) {
            if (other != ring && new Region.Filled(List.of(other), true).contains(point.x(), point.y())) {
                winding += evenOdd || Rings.doubleArea(other) > 0 ? 1 : -1;
            }
        }
        return winding;
    }
}
