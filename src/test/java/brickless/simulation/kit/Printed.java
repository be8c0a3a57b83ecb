package brickless.simulation.kit;

import java.util.Arrays;
import java.util.List;

/** What a program printed: lines of a name and values. */
record Printed(List<String> lines) {
    /** The values of the only line of that name. */
    List<String> words(String name) {
        List<String> found = lines.stream().filter(line -> line.equals(name) || line.startsWith(name + " ")).toList();
        if (found.size() != 1) {
            throw new AssertionError(found.size() + " lines named " + name + " in " + String.join("\n", lines));
        }
        String[] words = found.get(0).split(" ");
        return List.of(words).subList(1, words.length);
    }

    /** The same as numbers. */
    double[] numbers(String name) {
        return words(name).stream().mapToDouble(Double::parseDouble).toArray();
    }

    /** The same as a list. */
    List<Double> list(String name) {
        return words(name).stream().map(Double::valueOf).toList();
    }

    /** The first of them. */
    double number(String name) {
        return number(name, 0);
    }

    /** One value of a line as a number. */
    double number(String name, int index) {
        return Double.parseDouble(words(name).get(index));
    }

    /** The largest difference of two values of a line. */
    double spread(String name) {
        double[] values = numbers(name);
        return Arrays.stream(values).max().orElseThrow() - Arrays.stream(values).min().orElseThrow();
    }
}
