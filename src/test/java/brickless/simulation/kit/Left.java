package brickless.simulation.kit;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;

/** What programs have left behind: seen by them and by tests alike, because classes of this package are shared. */
public final class Left {
    private static final List<WeakReference<Object>> OBJECTS = new ArrayList<>();

    private Left() {}

    /** Remembers an object of a program weakly. */
    public static synchronized void behind(Object object) {
        OBJECTS.add(new WeakReference<>(object));
    }

    /** Takes the objects that programs have remembered. */
    public static synchronized List<WeakReference<Object>> taken() {
        List<WeakReference<Object>> taken = List.copyOf(OBJECTS);
        OBJECTS.clear();
        return taken;
    }
}
