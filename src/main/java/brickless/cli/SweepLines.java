package brickless.cli;

import brickless.simulation.SimulationSettings;
import brickless.trace.JsonFields;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * The lines of a sweep, on standard output or in a file that a later sweep can continue.
 *
 * <p>A file that is there must be the beginning of the same sweep: worlds and seeds of its lines are compared with the plan, and its last
 * line is made once more, which shows whether the program or a setting has changed since. A last line without its end is dropped.
 */
final class SweepLines implements AutoCloseable {
    private final Optional<Path> file;
    private final boolean closing;
    private OutputStream out;
    private int count;
    private int failed;

    private SweepLines(Optional<Path> file, OutputStream out) {
        this.file = file;
        this.closing = file.isPresent();
        this.out = out;
    }

    static SweepLines to(PrintStream stream) {
        return new SweepLines(Optional.empty(), stream);
    }

    static SweepLines in(Path file) {
        return new SweepLines(Optional.of(file), OutputStream.nullOutputStream());
    }

    /** Lines so far, those found included. */
    int count() {
        return count;
    }

    /** Runs among them that failed. */
    int failed() {
        return failed;
    }

    /**
     * Checks and keeps what is there, and makes ready to write behind it.
     *
     * @param again makes the line of a run
     */
    void continueFrom(List<SweepRun> plan, Map<String, SimulationSettings> settings, Function<SweepRun, String> again) throws IOException {
        if (file.isEmpty()) {
            return;
        }
        byte[] bytes = Files.exists(file.get()) ? Files.readAllBytes(file.get()) : new byte[0];
        int end = bytes.length;
        while (end > 0 && bytes[end - 1] != '\n') {
            end--;
        }
        List<String> lines = new String(bytes, 0, end, StandardCharsets.UTF_8).lines().toList();
        for (String line : lines) {
            found(line, plan, settings);
        }
        if (!lines.isEmpty() && !again.apply(plan.get(count - 1)).equals(lines.get(count - 1))) {
            throw other(count, "was made by another program or with other settings");
        }
        prepare(end);
    }

    private void prepare(int end) throws IOException {
        Path target = file.orElseThrow();
        try {
            if (target.toAbsolutePath().getParent() != null) {
                Files.createDirectories(target.toAbsolutePath().getParent());
            }
            if (Files.exists(target) && Files.size(target) != end) {
                try (var channel = Files.newByteChannel(target, StandardOpenOption.WRITE)) {
                    channel.truncate(end);
                }
            }
            out = Files.newOutputStream(target, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UsageException(target + ": cannot be written: " + e.getMessage());
        }
    }

    private void found(String line, List<SweepRun> plan, Map<String, SimulationSettings> settings) {
        if (count == plan.size()) {
            throw other(count + 1, "is beyond the end of this sweep");
        }
        SweepRun run = plan.get(count);
        try {
            JsonFields fields = JsonFields.parse(line);
            if (!fields.text("world").equals(settings.get(run.world()).world().name()) || fields.integer("seed") != run.seed()) {
                throw other(count + 1, "is of world " + fields.text("world") + " and seed " + fields.integer("seed") + ", not of "
                        + settings.get(run.world()).world().name() + " and " + run.seed());
            }
            count(fields);
        } catch (IllegalArgumentException e) {
            throw other(count + 1, e.getMessage());
        }
    }

    private UsageException other(int line, String what) {
        return new UsageException(file.orElseThrow() + ":" + line + ": " + what + "; give another --out, or remove the file to begin anew");
    }

    /** Writes a line at once, so that a killed sweep loses nothing that was done. */
    void add(String line) throws IOException {
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
        count(JsonFields.parse(line));
    }

    private void count(JsonFields fields) {
        failed += fields.flag("passed") ? 0 : 1;
        count++;
    }

    @Override public void close() throws IOException {
        if (closing) {
            out.close();
        }
    }
}
