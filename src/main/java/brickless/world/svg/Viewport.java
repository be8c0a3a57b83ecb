package brickless.world.svg;

/** What 100 % means for lengths: the size of the drawing in user units. */
record Viewport(double width, double height) {
    /** A length along x. */
    double x(SvgElement element, String attribute, double fallback) throws MalformedValueException {
        return length(element, attribute, fallback, width);
    }

    /** A length along y. */
    double y(SvgElement element, String attribute, double fallback) throws MalformedValueException {
        return length(element, attribute, fallback, height);
    }

    /** What 100 % means for a length in no particular direction. */
    double diagonal() {
        return Math.sqrt((width * width + height * height) / 2);
    }

    /** A size that must not be negative; NaN when missing or "auto". */
    double size(SvgElement element, String attribute, double reference) throws MalformedValueException {
        String text = element.attribute(attribute);
        if (text == null || text.equals("auto")) {
            return Double.NaN;
        }
        double value = LengthParser.parse(attribute, text, reference);
        if (value < 0) {
            throw new MalformedValueException(attribute + "=\"" + LengthParser.shortened(text)
                    + "\" must not be negative");
        }
        return value;
    }

    private static double length(SvgElement element, String attribute, double fallback, double reference)
            throws MalformedValueException {
        String text = element.attribute(attribute);
        return text == null ? fallback : LengthParser.parse(attribute, text, reference);
    }
}
