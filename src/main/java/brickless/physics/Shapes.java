package brickless.physics;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.FixtureDef;

/** Turns outlines into fixtures. */
final class Shapes {
    private Shapes() {}

    /** Convex pieces of all outlines. */
    static List<List<Point2>> pieces(List<List<Point2>> outlines) {
        List<List<Point2>> pieces = new ArrayList<>();
        for (List<Point2> outline : outlines) {
            pieces.addAll(ConvexParts.of(outline));
        }
        return pieces;
    }

    static double area(List<List<Point2>> pieces) {
        double area = 0;
        for (List<Point2> piece : pieces) {
            area += ConvexParts.signedArea(piece);
        }
        return area;
    }

    /** Area centroid; the origin if there is no area. */
    static Point2 centroid(List<List<Point2>> pieces) {
        double area = 0;
        double x = 0;
        double y = 0;
        for (List<Point2> ring : pieces) {
            for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                Point2 a = ring.get(j);
                Point2 b = ring.get(i);
                double cross = a.x() * b.y() - b.x() * a.y();
                area += cross / 2;
                x += (a.x() + b.x()) * cross / 6;
                y += (a.y() + b.y()) * cross / 6;
            }
        }
        return area == 0 ? new Point2(0, 0) : new Point2(x / area, y / area);
    }

    /** Distance of the farthest corner from a point. */
    static double radius(List<List<Point2>> pieces, Point2 centre) {
        double squared = 0;
        for (List<Point2> piece : pieces) {
            for (Point2 p : piece) {
                double dx = p.x() - centre.x();
                double dy = p.y() - centre.y();
                squared = Math.max(squared, dx * dx + dy * dy);
            }
        }
        return Math.sqrt(squared);
    }

    /** Adds pieces to a body whose own frame has its origin at {@code origin}. */
    static void attach(Body body, List<List<Point2>> pieces, Point2 origin, FixtureDef template) {
        for (List<Point2> piece : pieces) {
            template.shape = polygon(piece, origin);
            body.createFixture(template);
        }
    }

    private static PolygonShape polygon(List<Point2> piece, Point2 origin) {
        Vec2[] corners = new Vec2[piece.size()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new Vec2(Decimetres.of(piece.get(i).x() - origin.x()),
                    Decimetres.of(piece.get(i).y() - origin.y()));
        }
        PolygonShape shape = new PolygonShape();
        shape.set(corners, corners.length);
        return shape;
    }
}
