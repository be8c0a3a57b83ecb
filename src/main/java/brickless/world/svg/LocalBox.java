package brickless.world.svg;

import brickless.units.Lengths;
import brickless.world.Point2;
import java.util.List;

/**
 * The smallest box around shapes, upright in the coordinate system of the element that carries them (millimetres before
 * its transform).
 */
record LocalBox(double minX, double minY, double maxX, double maxY, Affine toPage) {
    static LocalBox of(Scope carrier, List<DrawnShape> shapes) throws MalformedValueException {
        if (carrier.toPage().isSingular()) {
            throw new MalformedValueException("its transform makes it vanish");
        }
        Affine fromPage = carrier.toPage().inverse();
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (DrawnShape shape : shapes) {
            Affine toLocal = shape.scope().toPage().equals(carrier.toPage()) ? Affine.IDENTITY
                    : fromPage.then(shape.scope().toPage());
            for (SubPath path : shape.paths()) {
                for (Point2 point : path.points()) {
                    Point2 p = toLocal.apply(point);
                    minX = Math.min(minX, p.x());
                    minY = Math.min(minY, p.y());
                    maxX = Math.max(maxX, p.x());
                    maxY = Math.max(maxY, p.y());
                }
            }
        }
        if (!(maxX >= minX && maxY >= minY)) {
            throw new MalformedValueException("draws nothing; it needs a shape that shows its place");
        }
        return new LocalBox(minX, minY, maxX, maxY, carrier.toPage());
    }

    boolean isEmpty() {
        return maxX - minX <= 0 && maxY - minY <= 0;
    }

    /** Middle of the box, metres on the page. */
    Point2 centre() {
        return metres(new Point2((minX + maxX) / 2, (minY + maxY) / 2));
    }

    /** Middle of the edge that faces the local +x direction, metres on the page. */
    Point2 front() {
        return metres(new Point2(maxX, (minY + maxY) / 2));
    }

    /** Its four corners, clockwise before a mirroring transform, metres on the page. */
    List<Point2> outline() {
        return List.of(metres(new Point2(minX, minY)), metres(new Point2(maxX, minY)), metres(new Point2(maxX, maxY)),
                metres(new Point2(minX, maxY)));
    }

    private Point2 metres(Point2 local) {
        Point2 p = toPage.apply(local);
        return new Point2(Lengths.metresFromMillimetres(p.x()), Lengths.metresFromMillimetres(p.y()));
    }
}
