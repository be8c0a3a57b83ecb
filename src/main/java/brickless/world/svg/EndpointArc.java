package brickless.world.svg;

import brickless.world.Point2;

/** An elliptical arc given by its end points; arithmetic of SVG 1.1, appendix F.6. */
final class EndpointArc {
    private EndpointArc() {}

    static void draw(Flattener out, double rxGiven, double ryGiven, double degrees, boolean large, boolean sweep,
            Point2 to)
            throws MalformedValueException {
        Point2 from = out.pen();
        if (from.equals(to)) {
            return;
        }
        if (rxGiven == 0 || ryGiven == 0) {
            out.lineTo(to);
            return;
        }
        Affine turn = Affine.rotate(degrees);
        Point2 half = turn.inverse().apply(new Point2((from.x() - to.x()) / 2, (from.y() - to.y()) / 2));
        double reach = square(half.x() / rxGiven) + square(half.y() / ryGiven);
        double grow = reach > 1 ? Math.sqrt(reach) : 1;
        double rx = rxGiven * grow;
        double ry = ryGiven * grow;
        double scaled = square(half.x() / rx) + square(half.y() / ry);
        double factor = Math.sqrt(Math.max(0, 1 / scaled - 1)) * (large == sweep ? -1 : 1);
        double cx = factor * half.y() / ry;
        double cy = -factor * half.x() / rx;
        double first = StrictMath.atan2(half.y() / ry - cy, half.x() / rx - cx);
        double last = StrictMath.atan2(-half.y() / ry - cy, -half.x() / rx - cx);
        double delta = last - first;
        if (sweep && delta < 0) {
            delta += 2 * Math.PI;
        } else if (!sweep && delta > 0) {
            delta -= 2 * Math.PI;
        }
        Affine centred = Affine.translate((from.x() + to.x()) / 2, (from.y() + to.y()) / 2).then(turn)
                .then(Affine.scale(rx, ry))
                .then(Affine.translate(cx, cy));
        out.arc(centred, first, delta, to);
    }

    private static double square(double value) {
        return value * value;
    }
}
