package brickless.simulation;

import brickless.loading.MainClasses;
import brickless.loading.ReachableClasses;
import brickless.program.Program;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The class files of a program and of the libraries it brings along, in a fixed order. */
public final class ProgramClasses {
    private final Program program;

    /** Those of a program. */
    public ProgramClasses(Program program) {
        this.program = program;
    }

    /** Reads those that the main class leads to: a folder may hold other programs, for other robots. */
    public List<byte[]> ofMain() {
        return ReachableClasses.from(program.mainClass(), files().stream().filter(file -> !isOurs(file)).toList());
    }

    /** A library may bring leJOS along; ours is used instead. */
    private static boolean isOurs(byte[] classFile) {
        String name = MainClasses.nameOf(classFile).orElse("");
        return name.startsWith("lejos.")
                && ProgramClasses.class.getResource("/" + name.replace('.', '/') + ".class") != null;
    }

    /** Reads them all. */
    public List<byte[]> files() {
        try {
            if (program.classPath().isEmpty()) {
                return besideMainClass();
            }
            List<byte[]> files = new ArrayList<>();
            for (Path entry : program.classPath()) {
                files.addAll(of(entry));
            }
            return files;
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the program's classes", e);
        }
    }

    private static List<byte[]> of(Path entry) throws IOException {
        if (Files.isDirectory(entry)) {
            return below(entry);
        }
        try (FileSystem jar = FileSystems.newFileSystem(entry)) {
            return below(jar.getPath("/"));
        }
    }

    private static List<byte[]> below(Path root) throws IOException {
        List<byte[]> files = new ArrayList<>();
        try (Stream<Path> found = Files.walk(root)) {
            for (Path file : found.filter(f -> f.toString().endsWith(".class")).sorted().toList()) {
                files.add(Files.readAllBytes(file));
            }
        }
        return files;
    }

    /**
     * Of a program on the application's class path (a test): the classes of the main class' package, or its own nested
     * ones.
     */
    private List<byte[]> besideMainClass() throws IOException {
        if (program.mainClass().isEmpty()) {
            return List.of();
        }
        String resource = program.mainClass().replace('.', '/') + ".class";
        URL url = Thread.currentThread().getContextClassLoader().getResource(resource);
        if (url == null) {
            throw new SetupException(program.mainClass() + ": no such class on the class path");
        }
        if (!url.getProtocol().equals("file")) {
            try (InputStream in = url.openStream()) {
                return List.of(in.readAllBytes());
            }
        }
        Path file = Path.of(URI.create(url.toString()));
        String prefix = file.getFileName().toString().replace(".class", "");
        List<byte[]> files = new ArrayList<>();
        try (Stream<Path> siblings = Files.list(file.getParent())) {
            for (Path sibling : siblings.filter(f -> f.getFileName().toString()
                    .matches(java.util.regex.Pattern.quote(prefix) + "(\\$.*)?\\.class")).sorted().toList()) {
                files.add(Files.readAllBytes(sibling));
            }
        }
        return files;
    }
}
