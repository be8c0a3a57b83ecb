package brickless.world.svg;

import java.util.HashSet;
import java.util.Set;

/** Names for things: the element's id, or its tag and line, made unique by a number where {@code use} repeats it. */
final class ElementIds {
    private final Set<String> taken = new HashSet<>();

    String of(SvgElement element) {
        String base = element.id().isEmpty() ? element.name() + "-line-" + element.line() : element.id();
        String id = base;
        for (int copy = 2; !taken.add(id); copy++) {
            id = base + "-" + copy;
        }
        return id;
    }
}
