package brickless.world.svg;

import java.util.Locale;

/** Reads a colour: a name, #rgb, #rrggbb (each also with opacity), rgb(), rgba(), hsl(), hsla(). */
final class ColourParser {
    private ColourParser() {}

    static Colour parse(String text) throws MalformedValueException {
        String value = text.strip().toLowerCase(Locale.ROOT);
        if (value.startsWith("#")) {
            return hex(value);
        }
        int open = value.indexOf('(');
        if (open > 0 && value.endsWith(")")) {
            return function(value.substring(0, open).strip(), value.substring(open + 1, value.length() - 1), text);
        }
        if (value.equals("transparent")) {
            return new Colour(Colour.BLACK.rgb(), 0);
        }
        Integer rgb = NamedColours.rgb(value);
        if (rgb == null) {
            throw unknown(text);
        }
        return Colour.opaque(rgb >> 16, rgb >> 8 & 255, rgb & 255);
    }

    private static Colour hex(String value) throws MalformedValueException {
        String digits = value.substring(1);
        if (!digits.matches("[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8}")) {
            throw unknown(value);
        }
        boolean brief = digits.length() < 6;
        int[] parts = new int[brief ? digits.length() : digits.length() / 2];
        for (int i = 0; i < parts.length; i++) {
            parts[i] = brief ? Character.digit(digits.charAt(i), 16) * 17
                    : Integer.parseInt(digits.substring(2 * i, 2 * i + 2), 16);
        }
        Colour colour = Colour.opaque(parts[0], parts[1], parts[2]);
        return parts.length == 4 ? new Colour(colour.rgb(), parts[3] / 255.0) : colour;
    }

    private static Colour function(String name, String arguments, String text) throws MalformedValueException {
        String[] parts = arguments.strip().split("\\s*[,/\\s]\\s*", -1);
        boolean rgb = name.equals("rgb") || name.equals("rgba");
        if (!rgb && !name.equals("hsl") && !name.equals("hsla") || parts.length < 3 || parts.length > 4) {
            throw unknown(text);
        }
        double opacity = parts.length == 4 ? share(parts[3], 1, text) : 1;
        if (rgb) {
            return new Colour(Colour.opaque(component(share(parts[0], 255, text)),
                    component(share(parts[1], 255, text)), component(share(parts[2], 255, text))).rgb(), opacity);
        }
        double hue = number(parts[0].endsWith("deg") ? parts[0].substring(0, parts[0].length() - 3) : parts[0],
                text) / 360;
        return new Colour(hsl(hue - Math.floor(hue), share(parts[1], 1, text), share(parts[2], 1, text)).rgb(),
                opacity);
    }

    private static Colour hsl(double hue, double saturation, double lightness) {
        double top = lightness <= 0.5 ? lightness * (1 + saturation) : lightness + saturation - lightness * saturation;
        double bottom = 2 * lightness - top;
        return Colour.opaque(component(wave(bottom, top, hue + 1.0 / 3)), component(wave(bottom, top, hue)),
                component(wave(bottom, top, hue - 1.0 / 3)));
    }

    private static double wave(double bottom, double top, double hue) {
        double h = (hue - Math.floor(hue)) * 6;
        if (h < 1) {
            return bottom + (top - bottom) * h;
        }
        return h < 3 ? top : h < 4 ? bottom + (top - bottom) * (4 - h) : bottom;
    }

    /** A number up to {@code full} or a percentage of it, as 0 to 1. */
    private static double share(String part, double full, String text) throws MalformedValueException {
        boolean percent = part.endsWith("%");
        double value = percent ? number(part.substring(0, part.length() - 1), text) / 100 : number(part, text) / full;
        return Math.max(0, Math.min(1, value));
    }

    private static double number(String part, String text) throws MalformedValueException {
        NumberScanner in = new NumberScanner(part.strip());
        if (!in.numberAhead()) {
            throw unknown(text);
        }
        double value = in.number();
        if (!in.atEnd()) {
            throw unknown(text);
        }
        return value;
    }

    private static int component(double share) {
        return (int) Math.floor(share * 255 + 0.5);
    }

    private static MalformedValueException unknown(String text) {
        return new MalformedValueException("\"" + LengthParser.shortened(text)
                + "\" is not a colour; allowed: a name such as red, #rgb, #rrggbb, rgb(), hsl(), none"
                        + Suggestion.nearest(text, NamedColours.names()));
    }
}
