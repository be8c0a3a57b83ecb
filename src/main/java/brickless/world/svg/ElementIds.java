package brickless.world.svg;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Names for things: the element's id, or its tag and line, made unique by a number where {@code use} repeats it. */
final class ElementIds {
    private final Set<String> taken = new HashSet<>();
    private final Map<String, Integer> lastCopies = new HashMap<>();

    String of(SvgElement element) {
        String base = element.id().isEmpty() ? element.name() + "-line-" + element.line() : element.id();
        String id = base;
        while (!taken.add(id)) {
            id = base + "-" + lastCopies.merge(base, 2, (last, first) -> last + 1);
        }
        return id;
    }
}
