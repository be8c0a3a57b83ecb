package brickless.loading.hints;

import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.objectweb.asm.tree.analysis.Value;

/**
 * What is known of a value while bytecode is interpreted symbolically.
 *
 * @param size 1 or 2 stack slots
 * @param kind what it is known to be
 * @param text class name, string, or name of the instruction that made an object, depending on the kind
 * @param number the number
 * @param ports ports the value may stand for
 * @param axle what is known of a wheel under construction
 */
record Clue(int size, Kind kind, String text, double number, SortedSet<String> ports, Axle axle) implements Value {
    /** Of a counter in a loop only that it varies is known; a container is an array, a list or a map. */
    enum Kind { UNKNOWN, NUMBER, COUNTER, TEXT, PORT, DEVICE, WHEEL, OBJECT, CONTAINER }

    private static final SortedSet<String> NO_PORTS = new TreeSet<>();
    private static final String PORT = "[A-D]|S[1-4]";

    static Clue unknown(int size) {
        return new Clue(size, Kind.UNKNOWN, "", Double.NaN, NO_PORTS, null);
    }

    static Clue number(int size, double value) {
        return new Clue(size, Kind.NUMBER, "", value, NO_PORTS, null);
    }

    static Clue counter() {
        return new Clue(1, Kind.COUNTER, "", Double.NaN, NO_PORTS, null);
    }

    /** A string; one that names a port stands for it. */
    static Clue text(String value) {
        return new Clue(1, Kind.TEXT, value, Double.NaN, isPort(value) ? new TreeSet<>(Set.of(value)) : NO_PORTS, null);
    }

    static Clue port(SortedSet<String> names) {
        return new Clue(1, Kind.PORT, "", Double.NaN, names, null);
    }

    static Clue port(String name) {
        return port(new TreeSet<>(Set.of(name)));
    }

    static Clue device(String lejosClass, SortedSet<String> ports) {
        return new Clue(1, Kind.DEVICE, lejosClass, Double.NaN, ports, null);
    }

    static Clue wheel(SortedSet<String> ports, Axle axle) {
        return new Clue(1, Kind.WHEEL, "", Double.NaN, ports, axle);
    }

    /** An object made by an instruction; what its constructor makes of it is kept under the instruction's name. */
    static Clue object(String instruction) {
        return new Clue(1, Kind.OBJECT, instruction, Double.NaN, NO_PORTS, null);
    }

    static Clue container(String instruction) {
        return new Clue(1, Kind.CONTAINER, instruction, Double.NaN, NO_PORTS, null);
    }

    /** The same at some of its ports. */
    Clue at(SortedSet<String> some) {
        return new Clue(size, kind, text, number, some, axle);
    }

    static boolean isPort(String name) {
        return name.matches(PORT);
    }

    @Override
    public int getSize() {
        return size;
    }

    boolean known() {
        return kind != Kind.UNKNOWN;
    }

    boolean is(Kind other) {
        return kind == other;
    }

    /** What both have in common: the same knowledge, or any of their ports. */
    Clue or(Clue other) {
        if (equals(other) || !other.known() || is(Kind.COUNTER)) {
            return this;
        }
        if (!known() || other.is(Kind.COUNTER) || is(Kind.OBJECT)) {
            return other;
        }
        if (kind == other.kind && (is(Kind.PORT) || is(Kind.TEXT) || is(Kind.WHEEL)
                || is(Kind.DEVICE) && Objects.equals(text, other.text))) {
            SortedSet<String> both = new TreeSet<>(ports);
            both.addAll(other.ports);
            return new Clue(size, kind, text, number, both, axle);
        }
        return this;
    }
}
