package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class ReachableClassesTest {
    static class Driving {
        public static void main(String[] args) {
            Object[] wheels = new Wheel[2];
            new Driving().drive(wheels);
        }

        void drive(Object[] wheels) {
            Runnable later = () -> Gear.shift();
            later.run();
        }
    }

    static class Wheel {}

    static class Gear extends Shaft {
        static void shift() {}
    }

    static class Shaft {}

    static class Plotting {
        public static void main(String[] args) throws ClassNotFoundException {
            Class.forName("brickless.loading.ReachableClassesTest$Pen");
        }
    }

    static class Pen {}

    private static final List<Class<?>> FOLDER = List.of(Shaft.class, Pen.class, Driving.class, Wheel.class,
            Plotting.class, Gear.class);

    private static byte[] fileOf(Class<?> type) {
        try (InputStream in = type.getResourceAsStream("/" + type.getName().replace('.', '/') + ".class")) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<String> from(String main) {
        return ReachableClasses.from(main, FOLDER.stream().map(ReachableClassesTest::fileOf).toList()).stream()
                .map(file -> MainClasses.nameOf(file).orElseThrow().replaceFirst(".*\\$", "")).toList();
    }

    @Test
    void whatTheMainClassUsesAndTheSuperclassesOfThatAreFoundInTheOrderGiven() {
        assertThat(from(Driving.class.getName())).containsExactly("Shaft", "Driving", "Wheel", "Gear");
    }

    @Test
    void classesAskedForByNameAreFound() {
        assertThat(from(Plotting.class.getName())).containsExactly("Pen", "Plotting");
    }

    @Test
    void withoutAMainClassAmongThemAllAreTaken() {
        assertThat(Stream.of("", "some.Other").map(main -> from(main).size())).containsExactly(6, 6);
    }
}
