package brickless.simulation;

import brickless.files.BrickFiles;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Puts what the user has for a program on its brick, into the folder where programs start. The user's files are only
 * read, when needed.
 */
final class Upload {
    /** What a program is made of is not uploaded as it is. */
    private static final List<String> CODE = List.of(".java", ".class");

    private final BrickFiles brick;
    private final SimulationSettings settings;

    Upload(BrickFiles brick, SimulationSettings settings) {
        this.brick = brick;
        this.settings = settings;
    }

    /**
     * Puts the files beside a program on its brick, and over them all that {@link SimulationSettings#files} holds.
     *
     * @param programFolder where the program lies: the files directly in it count, except those too large for a brick
     * @throws SetupException if they cannot be read, or are more than fit on the brick
     */
    void put(Optional<Path> programFolder) {
        programFolder.ifPresent(this::besideProgram);
        settings.files().ifPresent(this::all);
    }

    private void besideProgram(Path folder) {
        try (Stream<Path> found = Files.list(folder)) {
            for (Path file : found.filter(Upload::belongsToProgram).sorted().toList()) {
                if (Files.size(file) <= BrickFiles.CAPACITY_BYTES) {
                    put(folder, file);
                }
            }
        } catch (IOException | UncheckedIOException e) {
            throw new SetupException(folder + ": the files beside the program cannot be listed: " + e.getMessage());
        }
    }

    private static boolean belongsToProgram(Path file) {
        String name = file.getFileName().toString();
        return !name.startsWith(".") && CODE.stream().noneMatch(name::endsWith) && Files.isRegularFile(file)
                && Files.isReadable(file);
    }

    private void all(Path folder) {
        long bytes = 0;
        try (Stream<Path> found = Files.walk(folder)) {
            for (Path file : found.filter(file -> Files.isRegularFile(file) && !ofTheRun(file)).sorted().toList()) {
                bytes += Files.size(file);
                if (bytes > BrickFiles.CAPACITY_BYTES) {
                    throw new SetupException(folder + ": holds more than the " + (BrickFiles.CAPACITY_BYTES >> 20)
                            + " MiB that fit on the brick");
                }
                put(folder, file);
            }
        } catch (IOException | UncheckedIOException e) {
            throw new SetupException(folder + ": cannot be read: " + e.getMessage());
        }
    }

    /** What an earlier run left in the folder of this one must not change it. */
    private boolean ofTheRun(Path file) {
        return settings.out().filter(out -> absolute(file).startsWith(absolute(out))).isPresent();
    }

    /**
     * Checks what a user named.
     *
     * @throws SetupException if it is no folder, or one that the run would write
     */
    static void check(SimulationSettings settings) {
        settings.files().filter(folder -> !Files.isDirectory(folder)).ifPresent(folder -> {
            throw new SetupException(folder + ": " + (Files.exists(folder) ? "is no folder" : "no such folder")
                    + "; what it holds would be put on the brick");
        });
        settings.files().filter(folder -> settings.out().filter(out -> absolute(folder).startsWith(absolute(out)))
                .isPresent()).ifPresent(folder -> {
            throw new SetupException(folder + ": lies in the folder that this run writes, " + settings.out().get()
                    + "; copy it, or give another --out");
        });
    }

    private static Path absolute(Path path) {
        return path.toAbsolutePath().normalize();
    }

    private void put(Path folder, Path file) throws IOException {
        StringBuilder name = new StringBuilder(BrickFiles.WORKING_FOLDER);
        for (Path part : folder.relativize(file)) {
            name.append('/').append(part);
        }
        brick.put(name.toString(), file, Files.size(file));
    }
}
