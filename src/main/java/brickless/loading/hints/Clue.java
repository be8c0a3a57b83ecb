package brickless.loading.hints;

import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import org.objectweb.asm.tree.analysis.Value;

/**
 * What is known of a value while bytecode is interpreted symbolically.
 *
 * @param size 1 or 2 stack slots
 * @param kind what it is known to be
 * @param text port names, class name or string, depending on the kind
 * @param number number, or diameter of a wheel
 * @param ports ports the value may stand for
 * @param wheel what is known of a wheel under construction
 * @param origin place of the instruction that made the object, so that its constructor call can be found; −1 if none
 */
record Clue(int size, Kind kind, String text, double number, SortedSet<String> ports, Axle wheel, int origin) implements Value {
    enum Kind { UNKNOWN, NUMBER, TEXT, PORT, DEVICE, WHEEL, OBJECT }

    /** A wheel under construction: offset and track width are NaN until known. */
    record Axle(double diameter, double offset, double track, double gear) {}

    private static final SortedSet<String> NO_PORTS = new TreeSet<>();

    static Clue unknown(int size) {
        return new Clue(size, Kind.UNKNOWN, "", Double.NaN, NO_PORTS, null, -1);
    }

    static Clue number(int size, double value) {
        return new Clue(size, Kind.NUMBER, "", value, NO_PORTS, null, -1);
    }

    static Clue text(String value) {
        return new Clue(1, Kind.TEXT, value, Double.NaN, NO_PORTS, null, -1);
    }

    static Clue port(String name) {
        return new Clue(1, Kind.PORT, "", Double.NaN, new TreeSet<>(java.util.Set.of(name)), null, -1);
    }

    static Clue device(String lejosClass, SortedSet<String> ports) {
        return new Clue(1, Kind.DEVICE, lejosClass, Double.NaN, ports, null, -1);
    }

    static Clue wheel(SortedSet<String> ports, Axle axle) {
        return new Clue(1, Kind.WHEEL, "", Double.NaN, ports, axle, -1);
    }

    static Clue object(String type, int origin) {
        return new Clue(1, Kind.OBJECT, type, Double.NaN, NO_PORTS, null, origin);
    }

    @Override public int getSize() {
        return size;
    }

    boolean known() {
        return kind != Kind.UNKNOWN;
    }

    /** What both have in common: the same knowledge, or any of their ports. */
    Clue or(Clue other) {
        if (equals(other) || !other.known()) {
            return this;
        }
        if (!known()) {
            return other;
        }
        if (kind == other.kind && (kind == Kind.PORT || kind == Kind.DEVICE && Objects.equals(text, other.text))) {
            SortedSet<String> both = new TreeSet<>(ports);
            both.addAll(other.ports);
            return new Clue(size, kind, text, number, both, wheel, -1);
        }
        return this;
    }
}
