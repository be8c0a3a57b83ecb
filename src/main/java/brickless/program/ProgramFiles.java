package brickless.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** The files of the user that a program was made of. */
public final class ProgramFiles {
    private ProgramFiles() {}

    /**
     * Source files if the program was compiled, else class files or a jar; none for a class of the application's own
     * class path.
     *
     * @param directory directory that the program's name refers to
     * @throws ProgramException if they cannot be listed
     */
    public static List<Path> of(Path directory, Program program) throws ProgramException {
        Path named = directory.resolve(program.name());
        try {
            if (Files.isDirectory(named)) {
                return filesBelow(named, program.temporary().isPresent() ? ".java" : ".class");
            }
            if (!Files.isRegularFile(named)) {
                return List.of();
            }
            return program.temporary().isPresent() ? sources(named, program.temporary().get()) : List.of(named);
        } catch (IOException e) {
            throw new ProgramException(program.name() + ": cannot be read: " + e.getMessage());
        }
    }

    /**
     * The named source and those that the compiler found beside it: every class of a file's own name came from that
     * file.
     */
    private static List<Path> sources(Path named, Path classes) throws IOException {
        Set<Path> files = new LinkedHashSet<>(List.of(named));
        for (Path root : SourceCompiler.rootsOf(List.of(named))) {
            for (Path compiled : filesBelow(classes, ".class")) {
                Path source = root.resolve(classes.relativize(compiled).toString().replaceFirst("\\.class$", ".java"));
                if (Files.isRegularFile(source) && !Files.isSameFile(source, named)) {
                    files.add(source);
                }
            }
        }
        return new ArrayList<>(files);
    }

    private static List<Path> filesBelow(Path folder, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(ending) && Files.isRegularFile(file))
                    .sorted().toList();
        }
    }
}
