package brickless.trace;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.List;

/** Writes {@code signals.csv}: one row per sample, one column per signal of each robot; loads in spreadsheets and pandas. */
public final class SignalsWriter implements AutoCloseable {
    private final Writer out;
    private List<String> columns = List.of();

    /** Creates a writer; the first sample decides the columns. */
    public SignalsWriter(Writer out) {
        this.out = out;
    }

    /** Writes a row. */
    public void sample(Sample sample) {
        SignalRow row = new SignalRow(sample);
        try {
            if (columns.isEmpty()) {
                columns = row.names();
                out.write(String.join(",", columns) + "\n");
            }
            out.write(row.text(columns) + "\n");
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write signals.csv", e);
        }
    }

    @Override public void close() throws IOException {
        out.close();
    }
}
