package brickless.trace;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Writes {@code signals.csv}: one row per sample, one column per signal of each robot; loads in spreadsheets and
 * pandas.
 *
 * <p>Which signals there are is known only at the end: a sensor may be plugged in, or give more values in another mode,
 * while the program runs. So rows are kept and written on {@link #close}. Signals that came later have their columns
 * behind the others, empty before.
 */
public final class SignalsWriter implements AutoCloseable {
    private final Writer out;
    private final Set<String> columns = new LinkedHashSet<>();
    private final List<String> rows = new ArrayList<>();
    private final List<Integer> widths = new ArrayList<>();

    /** Creates a writer. */
    public SignalsWriter(Writer out) {
        this.out = out;
    }

    /** Adds a row. */
    public void sample(Sample sample) {
        SignalRow row = new SignalRow(sample);
        columns.addAll(row.names());
        rows.add(row.text(columns));
        widths.add(columns.size());
    }

    @Override
    public void close() throws IOException {
        try (out) {
            out.write(String.join(",", columns) + "\n");
            for (int i = 0; i < rows.size(); i++) {
                out.write(rows.get(i) + ",".repeat(columns.size() - widths.get(i)) + "\n");
            }
        }
    }
}
