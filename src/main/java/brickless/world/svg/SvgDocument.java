package brickless.world.svg;

import brickless.world.DescriptionException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/**
 * A drawing as a tree.
 *
 * @param file name for messages
 * @param folder where images may lie; empty for a drawing that is not a file
 * @param text the drawing as text
 * @param root the {@code svg} element
 * @param byId elements with an id; the first one of a name counts
 */
record SvgDocument(String file, Optional<Path> folder, String text, SvgElement root, Map<String, SvgElement> byId) {
    /** The error for something wrong at an element. */
    DescriptionException error(SvgElement element, String message) {
        return new DescriptionException(file, element.line(), element.title(), message);
    }

    /** File name without folder and extension. */
    static String nameOf(String file) {
        String last = file.substring(Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')) + 1);
        int dot = last.lastIndexOf('.');
        return dot > 0 ? last.substring(0, dot) : last;
    }
}
