package brickless.world.svg;

import brickless.world.Rgb;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Colours by reference. A gradient counts as its average colour: a sensor reads one number, and the result must not
 * depend on a renderer.
 */
final class PaintServers {
    private record Stop(double offset, Colour colour) {}

    private final SvgDocument document;
    private final StyleSheet sheet;

    PaintServers(SvgDocument document, StyleSheet sheet) {
        this.document = document;
        this.sheet = sheet;
    }

    /** Colour for {@code url(#id)} with an optional fallback colour behind it. */
    Optional<Colour> colour(String value, Colour current) throws MalformedValueException {
        int close = value.indexOf(')');
        if (close < 0) {
            throw new MalformedValueException("\"" + LengthParser.shortened(value) + "\" lacks a )");
        }
        String address = value.substring(4, close).strip().replaceAll("^[\"']|[\"']$", "");
        SvgElement server = address.startsWith("#") ? document.byId().get(address.substring(1)) : null;
        String fallback = value.substring(close + 1).strip();
        if (server == null) {
            if (fallback.isEmpty()) {
                throw new MalformedValueException("\"" + LengthParser.shortened(value)
                        + "\": no gradient with this id in the drawing");
            }
            return fallback.equals("none") ? Optional.empty() : Optional.of(ColourParser.parse(fallback));
        }
        return switch (server.name()) {
            case "linearGradient", "radialGradient" -> average(stops(server, current, new HashSet<>()));
            default -> throw new MalformedValueException("fill with <" + server.name()
                    + "> is not supported; allowed: colours and gradients"
                    + " (a gradient counts as its average colour)");
        };
    }

    private List<Stop> stops(SvgElement gradient, Colour current, Set<SvgElement> seen) throws MalformedValueException {
        if (!seen.add(gradient)) {
            throw new MalformedValueException("the gradient " + gradient.title() + " refers to itself");
        }
        List<Stop> stops = new ArrayList<>();
        for (SvgElement child : gradient.children()) {
            if (child.name().equals("stop")) {
                stops.add(stop(child, current, stops.isEmpty() ? 0 : stops.get(stops.size() - 1).offset()));
            }
        }
        String href = gradient.attribute("href");
        if (stops.isEmpty() && href != null && href.startsWith("#") && document.byId().containsKey(href.substring(1))) {
            return stops(document.byId().get(href.substring(1)), current, seen);
        }
        return stops;
    }

    private Stop stop(SvgElement element, Colour current, double atLeast) throws MalformedValueException {
        String colour = property(element, "stop-color", "black");
        Colour base = colour.equalsIgnoreCase("currentColor") ? current : ColourParser.parse(colour);
        double opacity = LengthParser.parse("stop-opacity", property(element, "stop-opacity", "1"), 1);
        double offset = LengthParser.parse("offset", element.attributes().getOrDefault("offset", "0"), 1);
        return new Stop(Math.max(atLeast, Math.min(1, offset)),
                new Colour(base.rgb(), base.opacity() * Math.max(0, Math.min(1, opacity))));
    }

    private String property(SvgElement element, String name, String fallback) {
        String value = element.attributes().getOrDefault(name, fallback);
        value = sheet.declarations(element).getOrDefault(name, value);
        String style = element.attribute("style");
        return style == null ? value : StyleSheet.parseDeclarations(style).getOrDefault(name, value);
    }

    /** Mean over the length of the gradient; outside the first and last stop their colours go on. */
    private static Optional<Colour> average(List<Stop> stops) {
        if (stops.isEmpty()) {
            return Optional.empty();
        }
        double[] sum = new double[4];
        Stop first = stops.get(0);
        Stop last = stops.get(stops.size() - 1);
        add(sum, first.colour(), Math.max(0, first.offset()));
        for (int i = 1; i < stops.size(); i++) {
            double half = (stops.get(i).offset() - Math.max(0, stops.get(i - 1).offset())) / 2;
            add(sum, stops.get(i - 1).colour(), half);
            add(sum, stops.get(i).colour(), half);
        }
        add(sum, last.colour(), 1 - last.offset());
        return Optional.of(new Colour(new Rgb(round(sum[0]), round(sum[1]), round(sum[2])), Math.min(1, sum[3])));
    }

    private static void add(double[] sum, Colour colour, double weight) {
        sum[0] += colour.rgb().red() * weight;
        sum[1] += colour.rgb().green() * weight;
        sum[2] += colour.rgb().blue() * weight;
        sum[3] += colour.opacity() * weight;
    }

    private static int round(double value) {
        return (int) Math.max(0, Math.min(255, Math.floor(value + 0.5)));
    }
}
