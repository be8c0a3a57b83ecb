package brickless.simulation;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;

/**
 * The folder with the files of a run. Files appear under their names only when the run is over; until then they end in
 * {@code .part}.
 */
final class RunFolder {
    private final Path folder;
    private final List<String> names = new ArrayList<>();

    RunFolder(Path folder) {
        this.folder = folder;
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new SetupException(folder + ": cannot be made a folder for the files of the run: " + e.getMessage());
        }
    }

    OutputStream open(String name) {
        names.add(name);
        try {
            return new BufferedOutputStream(Files.newOutputStream(part(name)), 1 << 16);
        } catch (IOException e) {
            throw new SetupException(folder.resolve(name) + ": cannot be written: " + e.getMessage());
        }
    }

    void write(String name, byte[] content) {
        try (OutputStream out = open(name)) {
            out.write(content);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    void write(String name, String content) {
        write(name, content.getBytes(StandardCharsets.UTF_8));
    }

    /** Gives every file its name; all streams must be closed. */
    void publish() {
        try {
            for (String name : names) {
                Files.move(part(name), folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Removes files that were begun, for a run that never went on. */
    void discard() {
        try {
            for (String name : names) {
                Files.deleteIfExists(part(name));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Path part(String name) {
        return folder.resolve(name + ".part");
    }

    @Override
    public String toString() {
        return folder.toString();
    }
}
