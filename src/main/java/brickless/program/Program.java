package brickless.program;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A program ready to run.
 *
 * @param name the program as the user named it
 * @param mainClass binary name of the class with the main method; empty: unknown
 * @param classPath directories and jars with its classes, in order; empty: they are on the application's own class path
 * @param temporary directory of classes compiled for this run, removed by {@link #close()}
 * @param remark what the user should know about how the program was found; empty: nothing
 */
public record Program(String name, String mainClass, List<Path> classPath, Optional<Path> temporary,
        Optional<String> remark) implements AutoCloseable {
    public Program {
        classPath = List.copyOf(classPath);
    }

    /** A program about which there is nothing to remark. */
    public Program(String name, String mainClass, List<Path> classPath, Optional<Path> temporary) {
        this(name, mainClass, classPath, temporary, Optional.empty());
    }

    /** A program whose classes are on the application's own class path, as in a test. */
    public static Program onClassPath(String mainClass) {
        return new Program(mainClass, mainClass, List.of(), Optional.empty());
    }

    /** A program of which nothing is known: it runs already, and was started by something else. */
    public static Program unknown() {
        return new Program("", "", List.of(), Optional.empty());
    }

    /** The main class without its package. */
    public String simpleName() {
        return mainClass.substring(mainClass.lastIndexOf('.') + 1);
    }

    Program compiledInto(Path directory) {
        return new Program(name, mainClass, classPath, Optional.of(directory), remark);
    }

    Program remarking(String text) {
        return new Program(name, mainClass, classPath, temporary, Optional.of(text));
    }

    @Override
    public void close() {
        temporary.ifPresent(Program::delete);
    }

    static void delete(Path directory) {
        try (Stream<Path> files = Files.walk(directory)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("cannot remove " + directory, e);
        }
    }
}
