package brickless.kernel;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** The fibres of one program. */
final class Roster {
    private final Map<Thread, Fibre> byThread = new IdentityHashMap<>();
    private final List<Fibre> live = new ArrayList<>();
    private int nonDaemons;
    private int lastId;

    int nextId() {
        return ++lastId;
    }

    void add(Fibre fibre) {
        byThread.put(fibre.thread, fibre);
        live.add(fibre);
        nonDaemons += fibre.daemon ? 0 : 1;
    }

    void ended(Fibre fibre) {
        live.remove(fibre);
        nonDaemons -= fibre.daemon ? 0 : 1;
    }

    /** The fibre of a thread that was started, ended or not; else null. */
    Fibre of(Thread thread) {
        return byThread.get(thread);
    }

    /** Fibres that have not ended, in order of starting. */
    List<Fibre> live() {
        return live;
    }

    int nonDaemons() {
        return nonDaemons;
    }

    void clear() {
        byThread.clear();
        live.clear();
    }
}
