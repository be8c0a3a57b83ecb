package brickless.trace;

import java.util.Arrays;

/**
 * One signal of a report: a number per sample, rounded to a fixed number of decimals, as text that compresses well.
 *
 * <p>The text is {@code {"places":p,"from":i,"deltas":[…]}}: the first {@code i} samples have no value; each entry is
 * the difference, in units of the last place, from the last value before it (0 at first), or {@code null} for no value.
 */
final class Column {
    private static final long NOTHING = Long.MIN_VALUE;

    private final int places;
    private final double scale;
    private long[] values = new long[64];
    private int from = -1;
    private int size;

    Column(int places) {
        this.places = places;
        scale = StrictMath.pow(10, places);
    }

    /** Sets the value at a sample; samples left out have none. Indices must rise. */
    void put(int sample, double value) {
        if (from < 0) {
            from = sample;
        }
        int index = sample - from;
        if (index >= values.length) {
            values = Arrays.copyOf(values, Math.max(index + 1, values.length * 2));
        }
        Arrays.fill(values, size, index, NOTHING);
        values[index] = Double.isFinite(value) ? Math.round(value * scale) : NOTHING;
        size = index + 1;
    }

    String json() {
        StringBuilder text = new StringBuilder("{\"places\":").append(places).append(",\"from\":")
                .append(Math.max(0, from)).append(",\"deltas\":[");
        long last = 0;
        for (int i = 0; i < size; i++) {
            text.append(i > 0 ? "," : "");
            if (values[i] == NOTHING) {
                text.append("null");
            } else {
                text.append(values[i] - last);
                last = values[i];
            }
        }
        return text.append("]}").toString();
    }
}
