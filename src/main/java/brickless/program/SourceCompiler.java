package brickless.program;

import brickless.loading.MainClasses;
import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.ProviderNotFoundException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

/**
 * Compiles leJOS programs with the JDK's compiler, against Brickless' own {@code lejos} classes.
 *
 * <p>Java 8 rules are tried first, because that is what leJOS programs were written for (there {@code yield()} is still
 * a method call) and because the resulting bytecode is the same on every JDK; programs that need newer Java are
 * compiled by the JDK's own rules.
 */
final class SourceCompiler {
    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);

    private static final Pattern COMMENT = Pattern.compile("//.*|(?s:/\\*.*?\\*/)");
    private static final Pattern MAIN = Pattern.compile("\\bvoid\\s+main\\s*\\(");

    private final List<Path> classPath;

    SourceCompiler(List<Path> classPath) {
        this.classPath = classPath;
    }

    /** Compiles sources, and what they refer to below the roots, into a directory. */
    void compile(List<Path> sources, Set<Path> roots, Path target) throws ProgramException, IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw new ProgramException(
                    "no Java compiler here: run with a JDK instead of a JRE, or give compiled classes");
        }
        CompileErrors asJava8 = attempt(compiler, sources, roots, target, List.of("--release", "8"));
        if (asJava8.count() == 0) {
            return;
        }
        CompileErrors asNewest = attempt(compiler, sources, roots, target, List.of());
        if (asNewest.count() > 0) {
            throw new CompileException((asNewest.count() <= asJava8.count() ? asNewest : asJava8).text());
        }
    }

    private CompileErrors attempt(JavaCompiler compiler, List<Path> sources, Set<Path> roots, Path target,
            List<String> rules) throws IOException {
        DiagnosticCollector<JavaFileObject> messages = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(messages, Locale.ROOT, null)) {
            files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(target));
            files.setLocationFromPaths(StandardLocation.SOURCE_PATH, roots);
            files.setLocationFromPaths(StandardLocation.CLASS_PATH, libraries());
            List<String> options = new ArrayList<>(List.of("-g", "-nowarn", "-proc:none", "-Xlint:none"));
            options.addAll(rules);
            StringWriter rest = new StringWriter();
            LenientSourceFiles lenient = new LenientSourceFiles(files);
            boolean fine = compiler.getTask(rest, lenient, messages, options, null,
                    lenient.wrap(files.getJavaFileObjectsFromPaths(sources))).call();
            if (fine) {
                return new CompileErrors(List.of());
            }
        }
        return new CompileErrors(messages.getDiagnostics().stream()
                .filter(message -> message.getKind() == Diagnostic.Kind.ERROR).toList());
    }

    /** Our leJOS before one that the program brings along, as when it runs; then the program's libraries. */
    private List<Path> libraries() {
        List<Path> ours = new ArrayList<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            ours.add(Path.of(entry));
        }
        Path lejos = ours.stream().filter(SourceCompiler::holdsLejos).findFirst().orElse(ours.get(0));
        Set<Path> all = new LinkedHashSet<>(List.of(lejos));
        all.addAll(classPath);
        all.addAll(ours);
        return List.copyOf(all);
    }

    private static boolean holdsLejos(Path entry) {
        try {
            return Files.exists(entry) && MainClasses.contains(entry, "lejos.hardware.Brick");
        } catch (IOException | ProviderNotFoundException e) {
            return false;
        }
    }

    /** The directories that the packages of the sources hang from, in order. */
    static Set<Path> rootsOf(List<Path> sources) throws IOException {
        Set<Path> roots = new LinkedHashSet<>();
        for (Path source : sources) {
            Path root = source.toAbsolutePath().normalize().getParent();
            String packageName = packageOf(source);
            if (!packageName.isEmpty()) {
                Path below = Path.of(packageName.replace('.', '/'));
                if (root.endsWith(below)) {
                    for (int i = 0; i < below.getNameCount(); i++) {
                        root = root.getParent();
                    }
                }
            }
            roots.add(root);
        }
        return roots;
    }

    /** Binary name of the class that a source file is named after. */
    static String classOf(Path source) throws IOException {
        String simple = source.getFileName().toString().replaceFirst("\\.java$", "");
        String packageName = packageOf(source);
        return packageName.isEmpty() ? simple : packageName + "." + simple;
    }

    /** Whether a source file looks as if it had a main method. */
    static boolean mayHaveMain(Path source) throws IOException {
        return MAIN.matcher(COMMENT.matcher(LenientSourceFiles.decode(Files.readAllBytes(source)))
                .replaceAll(" ")).find();
    }

    /** The package a source file declares, empty for none. */
    static String packageOf(Path source) throws IOException {
        Matcher matcher = PACKAGE.matcher(LenientSourceFiles.decode(Files.readAllBytes(source)));
        return matcher.find() ? matcher.group(1) : "";
    }
}
