package brickless.cli;

import brickless.simulation.SimulationSettings;
import brickless.trace.JsonFields;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * The lines of a sweep, on standard output or in a file that a later sweep can continue.
 *
 * <p>A file that is there must be the beginning of the same sweep: worlds and seeds of its lines are compared with the
 * plan, and its last line is made once more, which shows whether the program or a setting has changed since. A last
 * line without its end is dropped if it is the beginning of the one that belongs there.
 */
final class SweepLines implements AutoCloseable {
    private final Optional<Path> file;
    private OutputStream out;
    private FileChannel channel;
    private int count;
    private int failed;

    private SweepLines(Optional<Path> file, OutputStream out) {
        this.file = file;
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
    void continueFrom(List<SweepRun> plan, Map<String, SimulationSettings> settings, Function<SweepRun, String> again)
            throws IOException {
        if (file.isEmpty()) {
            return;
        }
        byte[] bytes = open(file.get());
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
        if (end < bytes.length && !(count < plan.size() && begins(again.apply(plan.get(count)), bytes, end))) {
            throw other(count + 1, "is no half-written line of this sweep");
        }
        channel.truncate(end);
        channel.position(end);
        out = Channels.newOutputStream(channel);
    }

    private static boolean begins(String line, byte[] bytes, int from) {
        byte[] wanted = line.getBytes(StandardCharsets.UTF_8);
        int length = bytes.length - from;
        return length <= wanted.length && Arrays.equals(wanted, 0, length, bytes, from, bytes.length);
    }

    /** What is in the file, which from now on is ours alone. */
    private byte[] open(Path target) {
        try {
            Files.createDirectories(target.toAbsolutePath().getParent());
            channel = FileChannel.open(target, StandardOpenOption.CREATE, StandardOpenOption.READ,
                    StandardOpenOption.WRITE);
            if (channel.tryLock() == null) {
                throw new UsageException(target + ": another sweep is writing it");
            }
            return Channels.newInputStream(channel).readAllBytes();
        } catch (OverlappingFileLockException e) {
            throw new UsageException(target + ": another sweep is writing it");
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
            if (!fields.text("world").equals(settings.get(run.world()).world().name())
                    || fields.integer("seed") != run.seed()) {
                throw other(count + 1, "is of world " + fields.text("world") + " and seed "
                        + fields.integer("seed") + ", not of "
                        + settings.get(run.world()).world().name() + " and " + run.seed());
            }
            count(fields);
        } catch (IllegalArgumentException e) {
            throw other(count + 1, e.getMessage());
        }
    }

    private UsageException other(int line, String what) {
        return new UsageException(file.orElseThrow() + ":" + line + ": " + what
                + "; give another --out, or remove the file to begin anew");
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

    @Override
    public void close() throws IOException {
        if (channel != null) {
            channel.close();
        }
    }
}
