package brickless.program;

import brickless.loading.MainClasses;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.stream.Stream;

/**
 * Turns what a user typed into a {@link Program}: a class name, a {@code .java} or {@code .class} file, a directory of
 * sources or classes, or a jar.
 */
public final class ProgramFinder {
    private final List<Path> classPath;
    private final Optional<String> wantedMain;
    private final Path directory;
    private boolean mainNeeded = true;

    /**
     * Creates a finder.
     *
     * @param directory directory that relative names refer to
     * @param classPath further directories and jars the program needs
     * @param wantedMain main class chosen by the user
     */
    public ProgramFinder(Path directory, List<Path> classPath, Optional<String> wantedMain) {
        this.directory = directory;
        this.classPath = List.copyOf(classPath);
        this.wantedMain = wantedMain;
    }

    /**
     * Finds (and where needed compiles) a program.
     *
     * @throws ProgramException with a message for the user if there is no such program or it does not compile
     */
    public Program find(String name) throws ProgramException {
        for (Path entry : classPath) {
            if (!Files.exists(directory.resolve(entry))) {
                throw new ProgramException(entry + ": no such class path entry");
            }
        }
        try {
            Path path = directory.resolve(name);
            if (!Files.exists(path)) {
                return byClassName(name);
            }
            if (Files.isDirectory(path)) {
                return fromDirectory(path, name);
            }
            if (name.endsWith(".java")) {
                return fromSource(path, name);
            }
            if (name.endsWith(".jar")) {
                return fromJar(path, name);
            }
            if (name.endsWith(".class")) {
                return fromClassFile(path, name);
            }
            throw new ProgramException(name + ": not a program: allowed are a class name, a .java or .class file, a "
                    + "directory or a .jar");
        } catch (IOException e) {
            throw new ProgramException(name + ": cannot be read: " + e.getMessage());
        }
    }

    /**
     * Finds (and where needed compiles) the classes of something that need not have a main class, or not a single one.
     *
     * @return a program whose main class may be the empty text
     * @throws ProgramException as {@link #find}
     */
    public Program findClasses(String name) throws ProgramException {
        mainNeeded = false;
        try {
            return find(name);
        } finally {
            mainNeeded = true;
        }
    }

    private Program byClassName(String name) throws ProgramException, IOException {
        boolean looksLikeFile = name.contains("/") || name.endsWith(".java") || name.endsWith(".jar")
                || name.endsWith(".class");
        if (!looksLikeFile) {
            for (Path entry : resolvedClassPath()) {
                if (MainClasses.contains(entry, name)) {
                    return checked(name, List.of(entry), name);
                }
            }
            if (ClassLoader.getSystemResource(fileOf(name)) != null) {
                return onClassPath(wantedMain.orElse(name), name);
            }
        }
        throw new ProgramException(name + ": no such program: neither a file or directory in " + directory
                + " nor a class on the class path");
    }

    private static String fileOf(String className) {
        return className.replace('.', '/') + ".class";
    }

    private static Program onClassPath(String main, String name) throws ProgramException, IOException {
        try (InputStream in = ClassLoader.getSystemResourceAsStream(fileOf(main))) {
            if (in == null || !MainClasses.hasMain(in.readAllBytes())) {
                throw new ProgramException(name + ": class " + main + " has no public static void main(String[])");
            }
        }
        return Program.onClassPath(main);
    }

    private Program fromDirectory(Path path, String name) throws ProgramException, IOException {
        List<Path> sources = filesEndingIn(path, ".java");
        if (sources.isEmpty()) {
            return choose(path, name);
        }
        return compiled(sources, target -> choose(target, name));
    }

    /** Compiles into a temporary directory, which goes with the program, or at once if no program comes of it. */
    private Program compiled(List<Path> sources, MainChoice choice) throws ProgramException, IOException {
        Path target = Files.createTempDirectory("brickless-classes");
        Program found = null;
        try {
            new SourceCompiler(resolvedClassPath()).compile(sources, SourceCompiler.rootsOf(sources), target);
            found = choice.in(target).compiledInto(target);
            return found;
        } finally {
            if (found == null) {
                Program.delete(target);
            }
        }
    }

    /** Decides what the main class is. */
    private interface MainChoice {
        Program in(Path classes) throws ProgramException, IOException;
    }

    private Program fromSource(Path path, String name) throws ProgramException, IOException {
        String simple = path.getFileName().toString().replaceFirst("\\.java$", "");
        String packageName = SourceCompiler.packageOf(path);
        String own = packageName.isEmpty() ? simple : packageName + "." + simple;
        return compiled(List.of(path), target -> wantedMain.isEmpty() && MainClasses.of(target).contains(own)
                ? checked(own, List.of(target), name) : choose(target, name));
    }

    private Program fromJar(Path path, String name) throws ProgramException, IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            Manifest manifest = jar.getManifest();
            String main = manifest == null ? null : manifest.getMainAttributes().getValue("Main-Class");
            if (main != null && wantedMain.isEmpty()) {
                return checked(main.trim(), List.of(path), name);
            }
        }
        return choose(path, name);
    }

    private Program fromClassFile(Path path, String name) throws ProgramException, IOException {
        String className = MainClasses.nameOf(Files.readAllBytes(path)).orElseThrow(() -> new ProgramException(name
                + ": not a class file"));
        Path root = path.toAbsolutePath().getParent();
        for (int dots = className.length() - className.replace(".", "").length(); dots > 0 && root != null; dots--) {
            root = root.getParent();
        }
        if (root == null || !Files.exists(root.resolve(className.replace('.', '/') + ".class"))) {
            throw new ProgramException(name + ": class " + className
                    + " does not lie in the directories of its package");
        }
        return checked(wantedMain.orElse(className), List.of(root), name);
    }

    private Program choose(Path classes, String name) throws ProgramException, IOException {
        List<String> mains = MainClasses.of(classes);
        if (wantedMain.isPresent()) {
            return checked(wantedMain.get(), List.of(classes), name);
        }
        if (!mainNeeded) {
            return withClassPath(name, "", List.of(classes));
        }
        if (mains.isEmpty()) {
            throw new ProgramException(name + ": no class with a public static void main(String[])");
        }
        if (mains.size() > 1) {
            throw new ProgramException(name + ": several main classes, choose one with --main: "
                    + String.join(", ", mains));
        }
        return checked(mains.get(0), List.of(classes), name);
    }

    private Program checked(String main, List<Path> entries, String name) throws ProgramException, IOException {
        Program program = withClassPath(name, main, entries);
        boolean found = !mainNeeded;
        for (Path entry : found ? List.<Path>of() : program.classPath()) {
            if (MainClasses.of(entry).contains(main)) {
                found = true;
                break;
            }
        }
        if (!found) {
            List<String> mains = MainClasses.of(entries.get(0));
            throw new ProgramException(name + ": class " + main + " has no public static void main(String[])"
                    + (mains.isEmpty() ? "" : "; main classes there: " + String.join(", ", mains)));
        }
        return program;
    }

    private Program withClassPath(String name, String main, List<Path> entries) {
        List<Path> all = new ArrayList<>(entries);
        all.addAll(resolvedClassPath());
        return new Program(name, main, all, Optional.empty());
    }

    private List<Path> resolvedClassPath() {
        return classPath.stream().map(directory::resolve).toList();
    }

    private static List<Path> filesEndingIn(Path directory, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(file -> file.toString().endsWith(ending) && Files.isRegularFile(file)).sorted()
                    .toList();
        }
    }
}
