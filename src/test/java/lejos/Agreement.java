package lejos;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/** Runs one driver with our classes and with the published ones, and compares what it reports. */
public final class Agreement {
    /** So many that threads which are left behind do not get in each other's way. */
    private static final int INDICES_PER_PROCESS = 250;
    private static final int ATTEMPTS = 3;

    private Agreement() {}

    /** What a driver saw: labels with numbers; truth values are 0 and 1. */
    public static final class Sightings extends LinkedHashMap<String, Double> {
        private static final long serialVersionUID = 1L;

        /** Notes a number. */
        public Sightings note(String label, double value) {
            if (put(label, value) != null) {
                throw new AssertionError("two sightings of " + label);
            }
            return this;
        }

        /** Notes a truth value. */
        public Sightings note(String label, boolean value) {
            return note(label, value ? 1 : 0);
        }
    }

    /**
     * Asserts agreement for the indices 0 to count − 1.
     *
     * @param driver class with a static method {@code play(int)} that returns a map of labels to numbers
     * @param tolerance greatest difference, relative to numbers beyond 1
     */
    public static void check(Class<?> driver, int count, double tolerance, IntFunction<Map<String, Double>> ours) {
        try (OriginalRunner runner = new OriginalRunner(driver, "play")) {
            for (int index = 0; index < count; index++) {
                compare(driver.getSimpleName() + " " + index, runner.run(index), ours.apply(index), tolerance);
            }
        }
    }

    /**
     * The same with each side in JVMs of its own, for classes whose threads do not end.
     *
     * @param folder for what the JVMs report
     */
    public static void checkInProcesses(Class<?> driver, int count, double tolerance, Path folder) {
        String tests = OriginalJar.testClasses(driver).toString();
        String original = OriginalJar.path() + File.pathSeparator + tests;
        for (int begin = 0; begin < count; begin += INDICES_PER_PROCESS) {
            int end = Math.min(count, begin + INDICES_PER_PROCESS);
            DriverProcess theirs = new DriverProcess(original, driver, begin, end, folder);
            DriverProcess ours = new DriverProcess(System.getProperty("java.class.path"), driver, begin, end, folder);
            List<Map<String, Double>> expected = theirs.sightings();
            List<Map<String, Double>> actual = ours.sightings();
            assertThat(expected).hasSize(end - begin).hasSameSizeAs(actual);
            for (int i = 0; i < expected.size(); i++) {
                if (!agree(expected.get(i), actual.get(i), tolerance)) {
                    replay(driver, begin + i, tolerance, folder);
                }
            }
        }
    }

    /** On a busy host the published threads may report a move too late; alone, an index must agree. */
    private static void replay(Class<?> driver, int index, double tolerance, Path folder) {
        String original = OriginalJar.path() + File.pathSeparator + OriginalJar.testClasses(driver);
        Map<String, Double> expected = Map.of();
        Map<String, Double> actual = Map.of();
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            expected = new DriverProcess(original, driver, index, index + 1, folder).sightings().get(0);
            actual = new DriverProcess(System.getProperty("java.class.path"), driver, index, index + 1, folder)
                    .sightings().get(0);
            if (agree(expected, actual, tolerance)) {
                return;
            }
        }
        compare(driver.getSimpleName() + " " + index, expected, actual, tolerance);
    }

    private static boolean agree(Map<String, Double> expected, Map<String, Double> actual, double tolerance) {
        return actual.keySet().equals(expected.keySet())
                && expected.entrySet().stream()
                .allMatch(entry -> close(actual.get(entry.getKey()), entry.getValue(), tolerance));
    }

    private static boolean close(double mine, double value, double tolerance) {
        return Double.compare(mine, value) == 0 || Math.abs(mine - value) <= tolerance * Math.max(1, Math.abs(value));
    }

    private static void compare(String where, Map<String, Double> expected, Map<String, Double> actual,
            double tolerance) {
        assertThat(actual.keySet()).as(where).isEqualTo(expected.keySet());
        expected.forEach((label, value) -> {
            double mine = actual.get(label);
            assertThat(close(mine, value, tolerance))
                    .as(where + ", " + label + ": original " + value + ", ours " + mine).isTrue();
        });
    }
}
