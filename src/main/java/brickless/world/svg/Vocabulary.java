package brickless.world.svg;

import brickless.world.DescriptionException;
import java.util.Set;
import java.util.TreeSet;

/**
 * The {@code data-*} attributes of each kind of file. A mistyped one would silently change what is simulated, so it is
 * an error.
 */
enum Vocabulary {
    WORLD("world", "data-solid", "data-mass-kg", "data-height-mm", "data-friction", "data-sound-absorbing", "data-zone",
            "data-edge", "data-beacon", "data-lamp-lux", "data-ambient-lux", "data-robot", "data-program", "data-model",
            "data-body"),
    ROBOT("robot", "data-part", "data-mass-kg", "data-height-mm", "data-friction", "data-port", "data-motor",
            "data-diameter-mm", "data-gear-ratio", "data-inverted", "data-sensor", "data-min-degrees",
            "data-max-degrees", "data-omni", "data-pivot", "data-heading-degrees", "data-backlash-degrees",
            "data-solid");

    /** Written by drawing programs (Illustrator, Figma) for their own use. */
    private static final Set<String> FOREIGN = Set.of("data-name");

    /** Said of the whole drawing. */
    private static final Set<String> OF_THE_DRAWING = Set.of("data-ambient-lux");

    private final String title;
    private final Set<String> names;

    Vocabulary(String title, String... names) {
        this.title = title;
        this.names = new TreeSet<>(Set.of(names));
    }

    /** Checks a whole drawing. */
    void check(SvgDocument document) throws DescriptionException {
        check(document, document.root());
    }

    private void check(SvgDocument document, SvgElement element) throws DescriptionException {
        for (String name : element.attributes().keySet()) {
            if (name.startsWith("data-") && !names.contains(name) && !FOREIGN.contains(name)) {
                throw document.error(element, complaint(name));
            }
            if (OF_THE_DRAWING.contains(name) && element != document.root()) {
                throw document.error(element, name + " is said of the whole drawing; put it on the outermost svg");
            }
        }
        for (SvgElement child : element.children()) {
            check(document, child);
        }
    }

    private String complaint(String name) {
        Vocabulary other = this == WORLD ? ROBOT : WORLD;
        if (other.names.contains(name)) {
            return name + " belongs in a " + other.title + " file, this is a " + title + " file";
        }
        return "unknown attribute " + name + Suggestion.nearest(name, names) + "; allowed in a " + title + " file: "
                + String.join(", ", names);
    }
}
