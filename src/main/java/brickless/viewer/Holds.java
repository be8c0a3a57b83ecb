package brickless.viewer;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Which viewers hold what: a thing is held from the first hand to the last. Owned by the driver. */
final class Holds {
    /** Hand of a viewer that did not say who it is. */
    static final int ANYBODY = 0;

    private final Map<String, Set<Integer>> hands = new LinkedHashMap<>();

    /** Whether anybody holds it. */
    boolean held(String what) {
        return hands.containsKey(what);
    }

    /** A viewer takes hold. */
    void take(String what, int viewer) {
        hands.computeIfAbsent(what, key -> new LinkedHashSet<>()).add(viewer);
    }

    /** A viewer lets go; true if it was the last that held it. */
    boolean letGo(String what, int viewer) {
        Set<Integer> holders = hands.get(what);
        if (holders == null || !holders.remove(viewer) || !holders.isEmpty()) {
            return false;
        }
        hands.remove(what);
        return true;
    }

    /** What a viewer holds. */
    List<String> heldBy(int viewer) {
        List<String> held = new ArrayList<>();
        hands.forEach((what, holders) -> {
            if (holders.contains(viewer)) {
                held.add(what);
            }
        });
        return held;
    }
}
