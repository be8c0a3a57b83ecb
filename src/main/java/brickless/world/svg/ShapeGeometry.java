package brickless.world.svg;

import brickless.world.Point2;
import java.util.List;
import java.util.Set;

/** The outline of a basic shape or path in its own user units. */
final class ShapeGeometry {
    static final Set<String> SHAPES = Set.of("rect", "circle", "ellipse", "line", "polyline", "polygon", "path",
            "image");

    private final SvgElement element;
    private final Viewport viewport;
    private final Flattener out;

    private ShapeGeometry(SvgElement element, Viewport viewport, Flattener out) {
        this.element = element;
        this.viewport = viewport;
        this.out = out;
    }

    static List<SubPath> of(SvgElement element, Viewport viewport, double tolerance, PointBudget budget)
            throws MalformedValueException {
        Flattener out = new Flattener(tolerance, budget);
        new ShapeGeometry(element, viewport, out).draw();
        return out.result();
    }

    private void draw() throws MalformedValueException {
        switch (element.name()) {
            case "rect" -> rectangle();
            case "image" -> box(viewport.x(element, "x", 0), viewport.y(element, "y", 0),
                    imageSize("width", viewport.width()), imageSize("height", viewport.height()));
            case "circle" -> {
                double r = orZero(viewport.size(element, "r", viewport.diagonal()));
                ellipse(r, r);
            }
            case "ellipse" -> {
                double rx = viewport.size(element, "rx", viewport.width());
                double ry = viewport.size(element, "ry", viewport.height());
                ellipse(orZero(Double.isNaN(rx) ? ry : rx), orZero(Double.isNaN(ry) ? rx : ry));
            }
            case "line" -> {
                out.moveTo(new Point2(viewport.x(element, "x1", 0), viewport.y(element, "y1", 0)));
                out.lineTo(new Point2(viewport.x(element, "x2", 0), viewport.y(element, "y2", 0)));
            }
            case "polyline" -> points(false);
            case "polygon" -> points(true);
            default -> PathParser.parse(element.attributes().getOrDefault("d", ""), out);
        }
    }

    private void rectangle() throws MalformedValueException {
        double x = viewport.x(element, "x", 0);
        double y = viewport.y(element, "y", 0);
        double w = orZero(viewport.size(element, "width", viewport.width()));
        double h = orZero(viewport.size(element, "height", viewport.height()));
        double rxGiven = viewport.size(element, "rx", viewport.width());
        double ryGiven = viewport.size(element, "ry", viewport.height());
        double rx = Math.min(w / 2, orZero(Double.isNaN(rxGiven) ? ryGiven : rxGiven));
        double ry = Math.min(h / 2, orZero(Double.isNaN(ryGiven) ? rxGiven : ryGiven));
        if (rx > 0 && ry > 0) {
            rounded(x, y, w, h, rx, ry);
        } else {
            box(x, y, w, h);
        }
    }

    private void box(double x, double y, double w, double h) throws MalformedValueException {
        if (w > 0 && h > 0) {
            out.moveTo(new Point2(x, y));
            out.lineTo(new Point2(x + w, y));
            out.lineTo(new Point2(x + w, y + h));
            out.lineTo(new Point2(x, y + h));
            out.close();
        }
    }

    private void rounded(double x, double y, double w, double h, double rx, double ry) throws MalformedValueException {
        if (w <= 0 || h <= 0) {
            return;
        }
        out.moveTo(new Point2(x + rx, y));
        corner(new Point2(x + w - rx, y), x + w - rx, y + ry, rx, ry, -1, new Point2(x + w, y + ry));
        corner(new Point2(x + w, y + h - ry), x + w - rx, y + h - ry, rx, ry, 0, new Point2(x + w - rx, y + h));
        corner(new Point2(x + rx, y + h), x + rx, y + h - ry, rx, ry, 1, new Point2(x, y + h - ry));
        corner(new Point2(x, y + ry), x + rx, y + ry, rx, ry, 2, new Point2(x + rx, y));
        out.close();
    }

    private void corner(Point2 from, double cx, double cy, double rx, double ry, int quarter, Point2 to)
            throws MalformedValueException {
        out.lineTo(from);
        out.arc(Affine.translate(cx, cy).then(Affine.scale(rx, ry)), quarter * Math.PI / 2, Math.PI / 2, to);
    }

    /** Four quarter arcs, so that the extreme points are exact. */
    private void ellipse(double rx, double ry) throws MalformedValueException {
        if (rx <= 0 || ry <= 0) {
            return;
        }
        double cx = viewport.x(element, "cx", 0);
        double cy = viewport.y(element, "cy", 0);
        Affine axes = Affine.translate(cx, cy).then(Affine.scale(rx, ry));
        Point2[] quarters = {new Point2(cx, cy + ry), new Point2(cx - rx, cy), new Point2(cx, cy - ry),
                new Point2(cx + rx, cy)};
        out.moveTo(new Point2(cx + rx, cy));
        for (int i = 0; i < 4; i++) {
            out.arc(axes, i * Math.PI / 2, Math.PI / 2, quarters[i]);
        }
        out.close();
    }

    private void points(boolean closed) throws MalformedValueException {
        NumberScanner in = new NumberScanner(element.attributes().getOrDefault("points", ""));
        in.skipSeparator();
        boolean first = true;
        while (!in.atEnd()) {
            double x = in.number();
            in.skipSeparator();
            if (in.atEnd()) {
                throw new MalformedValueException("points holds an odd number of values");
            }
            Point2 point = new Point2(x, in.number());
            in.skipSeparator();
            if (first) {
                out.moveTo(point);
            } else {
                out.lineTo(point);
            }
            first = false;
        }
        if (closed && !first) {
            out.close();
        }
    }

    private double imageSize(String attribute, double reference) throws MalformedValueException {
        double size = viewport.size(element, attribute, reference);
        if (Double.isNaN(size)) {
            throw new MalformedValueException("an image needs width and height in millimetres");
        }
        return size;
    }

    private static double orZero(double value) {
        return Double.isNaN(value) ? 0 : value;
    }
}
