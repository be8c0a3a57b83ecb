package programs.passing.host;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Identity hashes, and the order of hash tables that follows from them, are the same in every run.
 *
 * @expected exited 0
 */
public class Identity {
    enum Colour { RED, GREEN, BLUE, WHITE, BLACK }

    static class Plain {
    }

    static class Listener extends java.io.InputStream {
        @Override
        public int read() {
            return -1;
        }
    }

    public static void main(String[] args) {
        Plain plain = new Plain();
        System.out.println(plain.hashCode() == System.identityHashCode(plain));
        System.out.println(plain + " " + new Object() + " " + new int[1] + " " + new Listener());
        Set<Object> set = new HashSet<>();
        for (int i = 0; i < 5; i++) {
            set.add(new Plain());
            set.add(new Listener());
            set.add(new Thread());
        }
        set.forEach(System.out::println);
        System.out.println(Objects.hash(Colour.RED, plain) + " " + Colour.RED.hashCode() + " "
                + Arrays.hashCode(new Object[] {Colour.BLUE}));
        System.out.println(Set.of("a", "b", "c", "d") + " " + Map.of("x", 1, "y", 2, "z", 3));
        Map<Colour, Integer> map = new HashMap<>();
        for (Colour colour : Colour.values()) {
            map.put(colour, colour.ordinal());
        }
        System.out.println(map);
        Map<Object, String> objects = new HashMap<>();
        for (int i = 0; i < 8; i++) {
            objects.put(new Object(), "value " + i);
            objects.put(new int[i], "array " + i);
        }
        System.out.println(objects.values());
        Set<Class<?>> classes = new HashSet<>(
                Arrays.asList(String.class, Plain.class, int.class, Colour.class, Thread.class));
        System.out.println(classes);
    }
}
