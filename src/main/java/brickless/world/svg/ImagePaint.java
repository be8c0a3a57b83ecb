package brickless.world.svg;

import brickless.world.Paint;
import brickless.world.Point2;
import brickless.world.Region;
import brickless.world.Rgb;
import brickless.world.Texture;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An {@code image} on the floor: its pixels, fitted into its rectangle by {@code preserveAspectRatio}. */
final class ImagePaint {
    private ImagePaint() {}

    static Paint of(SvgDocument document, DrawnShape shape, String id) throws MalformedValueException {
        SvgElement element = shape.element();
        Affine toPage = shape.scope().toPage();
        if (toPage.isSingular()) {
            throw new MalformedValueException("its transform makes the image vanish");
        }
        ImagePixels pixels = ImageSource.load(document, element);
        Point2 corner = shape.paths().get(0).points().get(0);
        Point2 opposite = shape.paths().get(0).points().get(2);
        Affine fit = new ViewBox(0, 0, pixels.width(), pixels.height())
                .fitInto(corner.x(), corner.y(), opposite.x() - corner.x(),
                opposite.y() - corner.y(), element.attributes().getOrDefault("preserveAspectRatio", "xMidYMid meet"));
        Affine pixelsToMetres = Affine.scale(0.001, 0.001).then(toPage).then(fit);
        Affine back = pixelsToMetres.inverse();
        Texture texture = new Texture(pixels.width(), pixels.height(), pixels.argb(), back.a(), back.b(), back.c(),
                back.d(), back.e(), back.f());
        return new Paint(id, new Region.Filled(List.of(covered(pixels, fit, corner, opposite, toPage)), false),
                new Rgb(128, 128, 128), shape.scope().style().opacity(), Optional.of(texture));
    }

    /** The image's rectangle cut to the element's own (they differ when proportions do). */
    private static List<Point2> covered(ImagePixels pixels, Affine fit, Point2 corner, Point2 opposite, Affine toPage) {
        Point2 first = fit.apply(new Point2(0, 0));
        Point2 last = fit.apply(new Point2(pixels.width(), pixels.height()));
        double minX = Math.max(first.x(), corner.x());
        double minY = Math.max(first.y(), corner.y());
        double maxX = Math.min(last.x(), opposite.x());
        double maxY = Math.min(last.y(), opposite.y());
        List<Point2> ring = new ArrayList<>();
        for (Point2 p : List.of(new Point2(minX, minY), new Point2(maxX, minY), new Point2(maxX, maxY),
                new Point2(minX, maxY))) {
            ring.add(Affine.scale(0.001, 0.001).apply(toPage.apply(p)));
        }
        return ring;
    }
}
