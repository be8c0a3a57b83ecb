package brickless.loading;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * Exchanges what is static in the classes of a loader when another of its robots gets the processor.
 *
 * <p>A class takes part from the moment when a robot begins to initialise it, or when it is defined if it has no
 * initialiser: before that its fields have the values that the JVM gave them. Classes may be defined by any thread;
 * robots are exchanged by one at a time.
 */
final class StaticExchange {
    private final Map<Class<?>, StaticClass> untouched = new ConcurrentHashMap<>();
    private final Queue<StaticClass> added = new ConcurrentLinkedQueue<>();
    private final List<StaticClass> classes = new ArrayList<>();
    /** Those of which the loader has been asked for, the last run's. */
    private final List<RobotContext> robots = new ArrayList<>();
    private RobotContext present;

    /** The robot that may run; null before the first. */
    RobotContext present() {
        return present;
    }

    /** Another robot of a run. */
    void joins(RobotContext robot) {
        robots.add(robot);
    }

    /** All robots are over: drops what they have left, and gives the fields the values of one that did nothing. */
    void clear(RobotClassLoader loader) {
        takeAdded();
        robots.forEach(RobotContext::drop);
        robots.clear();
        RobotContext nobody = new RobotContext(loader, this);
        nobody.load(classes);
        present = null;
    }

    /** A class was defined. */
    void defined(Class<?> type, byte[] classFile) {
        StaticClass statics = StaticClass.of(type, classFile);
        if (statics.isEmpty()) {
            return;
        }
        if (statics.hasInitialiser()) {
            untouched.put(type, statics);
        } else {
            added.add(statics);
        }
    }

    /** The initialisation of a class begins, for whatever robot. */
    void initialisationBegins(Class<?> type) {
        StaticClass statics = untouched.remove(type);
        if (statics != null) {
            added.add(statics);
        }
    }

    /** Makes a robot the one that may run. */
    void enter(RobotContext next) {
        if (next == present) {
            return;
        }
        takeAdded();
        if (present != null) {
            present.save(classes);
        }
        present = next;
        next.load(classes);
    }

    private void takeAdded() {
        for (StaticClass statics = added.poll(); statics != null; statics = added.poll()) {
            classes.add(statics);
        }
    }
}
