package brickless.world.svg;

import brickless.world.svg.Style.StrokeStyle;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Works out the style of an element: its parent's, then presentation attributes, then style sheet, then
 * {@code style=""}.
 */
final class StyleResolver {
    private static final Set<String> PROPERTIES = Set.of("fill", "stroke", "fill-opacity", "stroke-opacity", "opacity",
            "fill-rule", "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray",
            "stroke-dashoffset", "vector-effect", "color", "display", "visibility", "clip-path", "mask");

    private final StyleSheet sheet;
    private final PaintServers servers;
    private final Viewport viewport;

    StyleResolver(StyleSheet sheet, PaintServers servers, Viewport viewport) {
        this.sheet = sheet;
        this.servers = servers;
        this.viewport = viewport;
    }

    Style resolve(Style parent, SvgElement element) throws MalformedValueException {
        Map<String, String> own = declarations(element);
        Colour colour = own.containsKey("color") && !inherits(own.get("color")) ? ColourParser.parse(own.get("color"))
                : parent.colour();
        return new Style(
                paint(own.get("fill"), parent.fill(), colour), paint(own.get("stroke"), parent.stroke(), colour),
                share("fill-opacity", own, parent.fillOpacity()),
                share("stroke-opacity", own, parent.strokeOpacity()),
                parent.opacity() * share("opacity", own, 1),
                inherits(own.get("fill-rule")) ? parent.evenOdd() : own.get("fill-rule").equals("evenodd"),
                line(own, parent.line()),
                colour,
                parent.displayed() && !"none".equals(own.get("display")),
                inherits(own.get("visibility")) ? parent.visible() : own.get("visibility").equals("visible"),
                parent.clipped() || isUsed(own.get("clip-path")) || isUsed(own.get("mask")));
    }

    private Map<String, String> declarations(SvgElement element) throws MalformedValueException {
        Map<String, String> own = new HashMap<>();
        for (String property : PROPERTIES) {
            if (element.has(property)) {
                own.put(property, element.attribute(property));
            }
        }
        own.putAll(sheet.declarations(element));
        if (element.has("style")) {
            own.putAll(StyleSheet.parseDeclarations(element.attribute("style")));
        }
        for (String geometry : List.of("transform", "translate", "rotate", "scale", "d", "offset-path")) {
            if (own.containsKey(geometry) && !own.get(geometry).equals("none")) {
                throw new MalformedValueException("style: " + geometry + " is not supported in CSS; use the attribute "
                        + geometry);
            }
        }
        return own;
    }

    private Optional<Colour> paint(String value, Optional<Colour> inherited, Colour current)
            throws MalformedValueException {
        if (inherits(value)) {
            return inherited;
        }
        if (value.startsWith("url(")) {
            return servers.colour(value, current);
        }
        return switch (value) {
            case "none" -> Optional.empty();
            case "currentColor", "currentcolor" -> Optional.of(current);
            default -> Optional.of(ColourParser.parse(value));
        };
    }

    private StrokeStyle line(Map<String, String> own, StrokeStyle parent) throws MalformedValueException {
        double width = inherits(own.get("stroke-width")) ? parent.width()
                : LengthParser.parse("stroke-width", own.get("stroke-width"), viewport.diagonal());
        if (width < 0) {
            throw new MalformedValueException("stroke-width must not be negative");
        }
        double miter = inherits(own.get("stroke-miterlimit")) ? parent.miterLimit()
                : LengthParser.parse("stroke-miterlimit", own.get("stroke-miterlimit"), Double.NaN);
        double offset = inherits(own.get("stroke-dashoffset")) ? parent.dashOffset()
                : LengthParser.parse("stroke-dashoffset", own.get("stroke-dashoffset"), viewport.diagonal());
        List<Double> dashes = inherits(own.get("stroke-dasharray")) ? parent.dashes()
                : dashes(own.get("stroke-dasharray"));
        return new StrokeStyle(width, inherits(own.get("stroke-linecap")) ? parent.cap() : own.get("stroke-linecap"),
                inherits(own.get("stroke-linejoin")) ? parent.join() : own.get("stroke-linejoin"), miter, dashes,
                offset, "non-scaling-stroke".equals(own.get("vector-effect")));
    }

    private List<Double> dashes(String value) throws MalformedValueException {
        if (value.equals("none")) {
            return List.of();
        }
        List<Double> lengths = new ArrayList<>();
        double sum = 0;
        for (String part : value.strip().split("[\\s,]+")) {
            double length = LengthParser.parse("stroke-dasharray", part, viewport.diagonal());
            if (length < 0) {
                throw new MalformedValueException("stroke-dasharray must not hold negative lengths");
            }
            sum += length;
            lengths.add(length);
        }
        if (sum <= 0) {
            return List.of();
        }
        if (lengths.size() % 2 == 1) {
            lengths.addAll(List.copyOf(lengths));
        }
        return List.copyOf(lengths);
    }

    private static double share(String property, Map<String, String> own, double fallback)
            throws MalformedValueException {
        String value = own.get(property);
        return inherits(value) ? fallback : Math.max(0, Math.min(1, LengthParser.parse(property, value, 1)));
    }

    private static boolean inherits(String value) {
        return value == null || value.isEmpty() || value.equals("inherit") || value.equals("unset");
    }

    private static boolean isUsed(String value) {
        return !inherits(value) && !value.equals("none");
    }
}
