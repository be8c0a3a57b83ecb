package brickless.world;

import java.util.List;

/** Plane geometry shared by the regions. */
final class Bounds {
    private Bounds() {}

    static double[] of(List<List<Point2>> lines, double margin) {
        double[] box = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
                Double.NEGATIVE_INFINITY};
        for (List<Point2> line : lines) {
            for (Point2 p : line) {
                box[0] = Math.min(box[0], p.x() - margin);
                box[1] = Math.min(box[1], p.y() - margin);
                box[2] = Math.max(box[2], p.x() + margin);
                box[3] = Math.max(box[3], p.y() + margin);
            }
        }
        return box;
    }

    static double distanceSquared(Point2 a, Point2 b, double x, double y) {
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        double length = dx * dx + dy * dy;
        double t = length == 0 ? 0 : Math.max(0, Math.min(1, ((x - a.x()) * dx + (y - a.y()) * dy) / length));
        double ex = a.x() + t * dx - x;
        double ey = a.y() + t * dy - y;
        return ex * ex + ey * ey;
    }
}
