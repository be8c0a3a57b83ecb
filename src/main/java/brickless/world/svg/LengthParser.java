package brickless.world.svg;

import brickless.units.Lengths;

/**
 * Reads a length: user units (= millimetres), or with a unit mm, cm, in, pt, pc, px (= user unit), or % of a reference
 * length.
 */
final class LengthParser {
    private static final double POINTS_PER_INCH = 72;

    private LengthParser() {}

    /** Value in user units; {@code reference} is what 100 % means, or NaN where percentages are not allowed. */
    static double parse(String attribute, String text, double reference) throws MalformedValueException {
        NumberScanner in = new NumberScanner(text.strip());
        if (!in.numberAhead()) {
            throw new MalformedValueException(attribute + "=\"" + shortened(text) + "\" is not a length");
        }
        double value = in.number();
        String unit = in.rest();
        double factor = switch (unit) {
            case "", "px", "mm" -> 1;
            case "cm" -> 10;
            case "in" -> Lengths.millimetresFromMetres(Lengths.METRES_PER_INCH);
            case "pt" -> Lengths.millimetresFromMetres(Lengths.METRES_PER_INCH) / POINTS_PER_INCH;
            case "pc" -> Lengths.millimetresFromMetres(Lengths.METRES_PER_INCH) / POINTS_PER_INCH * 12;
            case "%" -> reference / 100;
            default -> Double.NaN;
        };
        if (Double.isNaN(factor)) {
            throw new MalformedValueException(attribute + "=\"" + shortened(text)
                    + "\": unit is not supported here; allowed: none, mm, cm, in, pt, pc, px"
                    + (Double.isNaN(reference) ? "" : ", %"));
        }
        return value * factor;
    }

    static String shortened(String text) {
        String clean = text.replaceAll("\\s+", " ");
        return clean.length() <= 40 ? clean : clean.substring(0, 37) + "...";
    }
}
