package brickless.bench;

import brickless.trace.JsonFields;
import brickless.trace.JsonText;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/** What a measurement gave: numbers by name, in order; units are part of the names. */
public final class Figures {
    private static final int PLACES = 4;

    private final Map<String, Double> values = new LinkedHashMap<>();

    /** Adds a number. */
    public Figures put(String name, double value) {
        values.put(name, value);
        return this;
    }

    /** The numbers. */
    public Map<String, Double> values() {
        return values;
    }

    /** One number. */
    public double get(String name) {
        if (!values.containsKey(name)) {
            throw new IllegalArgumentException("no figure " + name + " among " + values.keySet());
        }
        return values.get(name);
    }

    /** One line of JSON. */
    public String json() {
        return JsonText.object(line -> values.forEach((name, value) -> line.number(name, value, PLACES)));
    }

    /** Reads {@link #json()} back. */
    static Figures parse(String json) {
        Figures figures = new Figures();
        JsonFields fields = JsonFields.parse(json);
        fields.names().forEach(name -> figures.put(name, fields.number(name)));
        return figures;
    }

    /** The middle one of some values, so that one disturbed round does no harm. */
    public static double median(double... values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int half = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }
}
