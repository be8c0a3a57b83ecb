package brickless.world.svg;

import brickless.world.DescriptionException;

/** The extent of a drawing: its viewBox in millimetres; without one, width and height. */
final class PageSize {
    private static final double LEAST_MILLIMETRES = 1;
    private static final double GREATEST_MILLIMETRES = 100_000;
    private static final double GREATEST_AREA_SQUARE_METRES = 1_000;

    private PageSize() {}

    static ViewBox of(SvgDocument document) throws DescriptionException {
        SvgElement root = document.root();
        try {
            ViewBox box = root.has("viewBox") ? ViewBox.parse(root.attribute("viewBox"))
                    : new ViewBox(0, 0, side(root, "width"), side(root, "height"));
            check(box);
            return box;
        } catch (MalformedValueException e) {
            throw document.error(root, e.getMessage());
        }
    }

    private static double side(SvgElement root, String attribute) throws MalformedValueException {
        if (!root.has(attribute)) {
            throw new MalformedValueException(
                    "the drawing has no size; give svg a viewBox in millimetres, such as viewBox=\"0 0 2000 1500\"");
        }
        return LengthParser.parse(attribute, root.attribute(attribute), Double.NaN);
    }

    private static void check(ViewBox box) throws MalformedValueException {
        boolean fits = box.width() >= LEAST_MILLIMETRES && box.width() <= GREATEST_MILLIMETRES
                && box.height() >= LEAST_MILLIMETRES
                && box.height() <= GREATEST_MILLIMETRES
                        && box.width() * box.height() / 1e6 <= GREATEST_AREA_SQUARE_METRES;
        if (!fits) {
            throw new MalformedValueException(
                    "a drawing of this size cannot be simulated; allowed: 1 to 100000 mm (100 m) a side and up to "
                            + "1000 square metres");
        }
    }
}
