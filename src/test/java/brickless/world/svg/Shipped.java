package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The files of the repository that tests read. */
final class Shipped {
    private Shipped() {}

    static Path file(String path) {
        String home = System.getProperty("brickless.home");
        assertThat(home).as("system property brickless.home, the folder of the repository").isNotNull();
        return Path.of(home, path);
    }

    static List<Path> worlds() {
        return drawings("sim/worlds");
    }

    static List<Path> robots() {
        return drawings("sim/robots");
    }

    private static List<Path> drawings(String folder) {
        try (Stream<Path> files = Files.list(file(folder))) {
            return files.filter(file -> file.toString().endsWith(".svg")).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
