package brickless.world.svg;

import brickless.world.DescriptionException;
import brickless.world.Paint;
import brickless.world.Point2;
import brickless.world.Region;
import java.util.ArrayList;
import java.util.List;

/** What a shape without a meaning leaves on the floor: its fill, then its line, or the pixels of an image. */
final class FloorPaints {
    private FloorPaints() {}

    static List<Paint> of(SvgDocument document, DrawnShape shape, String id)
            throws DescriptionException, MalformedValueException {
        Style style = shape.scope().style();
        List<List<Point2>> rings = shape.fillRings();
        List<Paint> paints = new ArrayList<>();
        if (shape.element().name().equals("image")) {
            if (!rings.isEmpty() && style.opacity() > 0) {
                paints.add(ImagePaint.of(document, shape, id));
            }
            return paints;
        }
        if (style.fill().isPresent() && !rings.isEmpty()) {
            add(paints, id, new Region.Filled(rings, style.evenOdd()), style.fill().get(),
                    style.fillOpacity() * style.opacity());
        }
        if (style.stroke().isPresent()) {
            List<List<Point2>> pieces = shape.strokePieces();
            if (!pieces.isEmpty()) {
                add(paints, id, new Region.Filled(pieces, false), style.stroke().get(),
                        style.strokeOpacity() * style.opacity());
            }
        }
        return paints;
    }

    private static void add(List<Paint> paints, String id, Region region, Colour colour, double opacity) {
        if (colour.opacity() * opacity > 0) {
            paints.add(new Paint(id, region, colour.rgb(), colour.opacity() * opacity));
        }
    }
}
