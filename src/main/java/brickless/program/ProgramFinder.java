package brickless.program;

import brickless.loading.MainClasses;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
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
        List<Path> libraries = filesEndingIn(path, ".jar");
        List<Path> sources = filesEndingIn(path, ".java");
        if (sources.isEmpty()) {
            return choose(path, libraries, name);
        }
        Set<Path> roots = SourceCompiler.rootsOf(sources);
        try {
            return compiled(sources, roots, libraries, target -> choose(target, libraries, name));
        } catch (CompileException whole) {
            return fromOneSource(sources, roots, libraries, name, whole);
        }
    }

    /**
     * A folder that does not compile as a whole may hold a program that does, beside broken files, tests, and programs
     * for the PC.
     */
    private Program fromOneSource(List<Path> sources, Set<Path> roots, List<Path> libraries, String name,
            CompileException whole) throws ProgramException, IOException {
        Map<String, Path> mains = new TreeMap<>();
        for (Path source : sources) {
            if (SourceCompiler.mayHaveMain(source)) {
                mains.putIfAbsent(SourceCompiler.classOf(source), source);
            }
        }
        wantedMain.ifPresent(wanted -> mains.keySet().retainAll(Set.of(wanted)));
        if (!mainNeeded || mains.isEmpty()) {
            throw whole;
        }
        if (mains.size() > 1) {
            throw new ProgramException(whole.getMessage() + "\nThe rest may run: choose a main class with --main: "
                    + String.join(", ", mains.keySet()));
        }
        Map.Entry<String, Path> main = mains.entrySet().iterator().next();
        Set<Path> ownRootFirst = new LinkedHashSet<>(SourceCompiler.rootsOf(List.of(main.getValue())));
        ownRootFirst.addAll(roots);
        Program program = compiled(List.of(main.getValue()), ownRootFirst, libraries,
                target -> checked(main.getKey(), libraries, target, name));
        return program.remarking("compiled without the rest of " + name + ", which has errors: "
                + whole.getMessage().lines().findFirst().orElse(""));
    }

    /** Compiles into a temporary directory, which goes with the program, or at once if no program comes of it. */
    private Program compiled(List<Path> sources, Set<Path> roots, List<Path> libraries, MainChoice choice)
            throws ProgramException, IOException {
        Path target = Files.createTempDirectory("brickless-classes");
        Program found = null;
        try {
            List<Path> all = new ArrayList<>(resolvedClassPath());
            all.addAll(libraries);
            new SourceCompiler(all).compile(sources, roots, target);
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
        String own = SourceCompiler.classOf(path);
        return compiled(List.of(path), SourceCompiler.rootsOf(List.of(path)), List.of(),
                target -> wantedMain.isEmpty() && MainClasses.of(target).contains(own)
                        ? checked(own, List.of(target), name) : choose(target, List.of(), name));
    }

    private Program fromJar(Path path, String name) throws ProgramException, IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            Manifest manifest = jar.getManifest();
            String main = manifest == null ? null : manifest.getMainAttributes().getValue("Main-Class");
            if (main != null && wantedMain.isEmpty()) {
                return checked(main.trim(), List.of(path), name);
            }
        }
        return choose(path, List.of(), name);
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

    private Program choose(Path classes, List<Path> libraries, String name) throws ProgramException, IOException {
        List<String> mains = MainClasses.of(classes);
        if (wantedMain.isPresent()) {
            return checked(wantedMain.get(), libraries, classes, name);
        }
        if (!mainNeeded) {
            return withClassPath(name, "", with(classes, libraries));
        }
        if (mains.isEmpty()) {
            throw new ProgramException(name + ": no class with a public static void main(String[])");
        }
        if (mains.size() > 1) {
            throw new ProgramException(name + ": several main classes, choose one with --main: "
                    + String.join(", ", mains));
        }
        return checked(mains.get(0), libraries, classes, name);
    }

    private Program checked(String main, List<Path> libraries, Path classes, String name)
            throws ProgramException, IOException {
        return checked(main, with(classes, libraries), name);
    }

    private static List<Path> with(Path classes, List<Path> libraries) {
        List<Path> all = new ArrayList<>(List.of(classes));
        all.addAll(libraries);
        return all;
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
