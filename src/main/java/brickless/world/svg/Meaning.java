package brickless.world.svg;

import brickless.world.DescriptionException;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * The {@code data-*} attributes in force at an element: its own and those of its groups. Errors point at the element
 * that says so.
 */
final class Meaning {
    /** What a shape is. An element that states one of these is no longer what its groups say. */
    private static final Set<String> KINDS = Set.of("data-solid", "data-zone", "data-edge", "data-beacon",
            "data-lamp-lux");

    private record Entry(String value, SvgElement source) {}

    private final SvgDocument document;
    private final Map<String, Entry> entries;

    private Meaning(SvgDocument document, Map<String, Entry> entries) {
        this.document = document;
        this.entries = entries;
    }

    static Meaning none(SvgDocument document) {
        return new Meaning(document, Map.of());
    }

    Meaning with(SvgElement element) {
        Map<String, Entry> merged = null;
        for (Map.Entry<String, String> attribute : element.attributes().entrySet()) {
            if (attribute.getKey().startsWith("data-")) {
                merged = merged == null ? inherited(element) : merged;
                merged.put(attribute.getKey(), new Entry(attribute.getValue(), element));
            }
        }
        return merged == null ? this : new Meaning(document, merged);
    }

    private Map<String, Entry> inherited(SvgElement element) {
        Map<String, Entry> kept = new TreeMap<>(entries);
        if (KINDS.stream().anyMatch(element::has)) {
            kept.keySet().removeAll(KINDS);
        }
        return kept;
    }

    boolean has(String name) {
        return entries.containsKey(name);
    }

    /** The value as written. */
    Optional<String> text(String name) {
        return Optional.ofNullable(entries.get(name)).map(Entry::value);
    }

    /** A name that must not be empty. */
    String name(String name) throws DescriptionException {
        String value = entries.get(name).value();
        if (value.isEmpty()) {
            throw error(name, name + " needs a name");
        }
        return value;
    }

    double number(String name, double fallback, double least, double greatest) throws DescriptionException {
        if (!has(name)) {
            return fallback;
        }
        String value = entries.get(name).value();
        double number = Double.NaN;
        try {
            NumberScanner in = new NumberScanner(value);
            number = in.number();
            number = in.atEnd() ? number : Double.NaN;
        } catch (MalformedValueException e) {
            number = Double.NaN;
        }
        if (!(number >= least && number <= greatest)) {
            throw error(name, name + "=\"" + LengthParser.shortened(value) + "\" is not a number in range; allowed: "
                    + plain(least) + " to " + plain(greatest));
        }
        return number;
    }

    /** True for an attribute that is empty, "true" or "yes"; false for a missing one, "false" or "no". */
    boolean flag(String name) throws DescriptionException {
        return switch (choice(name, "false", "true", "false", "yes", "no", "")) {
            case "true", "yes", "" -> true;
            default -> false;
        };
    }

    String choice(String name, String fallback, String... allowed) throws DescriptionException {
        if (!has(name)) {
            return fallback;
        }
        String value = entries.get(name).value();
        for (String one : allowed) {
            if (one.equals(value)) {
                return value;
            }
        }
        Set<String> shown = new LinkedHashSet<>(Arrays.asList(allowed));
        shown.remove("");
        throw error(name, name + "=\"" + LengthParser.shortened(value) + "\" is not known"
                + Suggestion.nearest(value, shown) + "; allowed: " + String.join(", ", shown));
    }

    /** The error for the value of an attribute that is present. */
    DescriptionException error(String name, String message) {
        return document.error(entries.get(name).source(), message);
    }

    private static String plain(double value) {
        boolean whole = value == Math.rint(value);
        return whole ? Long.toString((long) value) : BigDecimal.valueOf(value).toPlainString();
    }
}
