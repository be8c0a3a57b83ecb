package lejos;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntFunction;

/** Runs one driver with our classes and with the published ones, and compares what it reports. */
public final class Agreement {
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

    private static void compare(String where, Map<String, Double> expected, Map<String, Double> actual, double tolerance) {
        assertThat(actual.keySet()).as(where).isEqualTo(expected.keySet());
        expected.forEach((label, value) -> {
            double mine = actual.get(label);
            boolean close = Double.compare(mine, value) == 0
                    || Math.abs(mine - value) <= tolerance * Math.max(1, Math.abs(value));
            assertThat(close).as(where + ", " + label + ": original " + value + ", ours " + mine).isTrue();
        });
    }
}
