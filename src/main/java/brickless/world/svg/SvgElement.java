package brickless.world.svg;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * An element of a drawing: local name, attributes without a namespace (and {@code xlink:href} as {@code href}),
 * children, line.
 */
final class SvgElement {
    private final String name;
    private final int line;
    private final SvgElement parent;
    private final Map<String, String> attributes = new LinkedHashMap<>();
    private final List<SvgElement> children = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();

    SvgElement(String name, int line, SvgElement parent) {
        this.name = name;
        this.line = line;
        this.parent = parent;
        if (parent != null) {
            parent.children.add(this);
        }
    }

    String name() {
        return name;
    }

    int line() {
        return line;
    }

    SvgElement parent() {
        return parent;
    }

    List<SvgElement> children() {
        return children;
    }

    Map<String, String> attributes() {
        return attributes;
    }

    /** Trimmed value, or null if the attribute is missing. */
    String attribute(String attributeName) {
        return attributes.get(attributeName);
    }

    boolean has(String attributeName) {
        return attributes.containsKey(attributeName);
    }

    String id() {
        return attributes.getOrDefault("id", "");
    }

    void put(String attributeName, String value) {
        attributes.put(attributeName, value.strip());
    }

    void append(String characters) {
        text.append(characters);
    }

    /** Character content of this element itself. */
    String text() {
        return text.toString();
    }

    /** How messages call this element: its id, else its tag. */
    String title() {
        return id().isEmpty() ? "<" + name + ">" : id();
    }
}
